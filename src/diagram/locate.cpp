// Nearest neighbour location by walking (paper, section 4): from a site to any neighbour that is nearer, until there is none.
#include "diagram/delaunay_graph.h"
#include "predicate/approx_distance.h"
#include "predicate/predicates.h"

namespace apollonius {

VertexId DelaunayGraph::nearest(double x, double y, VertexId start) const {
  VertexId best = start;
  if (visibleCount_ == 1) return best;
  ApproxDistance bestDistance(x, y, site(best));
  HalfedgeId h = graph_.outgoing(best);
  HalfedgeId begin = h;
  do {
    const VertexId v = graph_.target(h);
    if (v != kInfinity) {
      const ApproxDistance distance(x, y, site(v));
      const double margin = bestDistance.value - distance.value;
      const double bound = bestDistance.bound + distance.bound;
      // Distances that cannot be told apart in doubles are compared exactly; ties have a winner, so the walk ends.
      if (margin > bound || (!(margin < -bound) && isNearer(x, y, site(best), site(v)))) {
        best = v;
        bestDistance = distance;
        begin = h = graph_.twin(h);  // the edge back: its other end is not nearer
      }
    }
    h = graph_.rotateCcw(h);
  } while (h != begin);
  return best;
}

}  // namespace apollonius
