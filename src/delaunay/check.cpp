// The invariants of a Delaunay graph, exactly checked; the first broken one is named with its ids.
#include <cmath>

#include "base/flat_array.h"
#include "delaunay/delaunay_graph.h"
#include "delaunay/proof.h"

namespace apollonius::internal {

namespace {

/// Can both be the same circle or half-plane, within their errors? NaNs come with infinite errors.
bool agree(const VoronoiCircle& a, const VoronoiCircle& b) {
  if (a.isHalfPlane() != b.isHalfPlane()) return false;
  const double error = (double{a.error} + double{b.error}) * (1 + 0x1p-20);
  const auto isClose = [](double x, double y, double bound) { return !(std::abs(x - y) > bound); };
  if (!a.isHalfPlane())
    return isClose(a.x, b.x, error) && isClose(a.y, b.y, error) && isClose(a.s, b.s, error);
  const double slope = (double{a.slope} + double{b.slope}) * (1 + 0x1p-20);
  return isClose(a.x, b.x, slope) && isClose(a.y, b.y, slope) && isClose(a.s, b.s, error);
}

}  // namespace

const char* DelaunayGraph::check(std::uint32_t& where) const {
  if (const char* broken = graph_.check(where)) return broken;
  std::size_t vertices = 0;
  for (std::size_t v = 1; v < graph_.vertexSlots(); ++v)
    vertices += graph_.hasVertex(VertexId{static_cast<std::uint32_t>(v)});
  where = static_cast<std::uint32_t>(visibleCount_);
  if (visibleCount_ >= 2 ? vertices != visibleCount_ : vertices != 0)
    return "the count of visible sites is wrong: count";
  if (visibleCount_ > 0 && (recent_ == kNoVertex || !isVisible(recent_)))
    return "walks start from a site without a cell: count";

  if (graph_.isEmpty()) return nullptr;
  FlatArray<VoronoiCircle> circles;
  if (const char* broken = findContradiction(*this, circles, where)) return broken;
  for (const FaceId f : graph_.faces()) {
    where = static_cast<std::uint32_t>(halfedgeOf(f, 0));
    if (agree(circle(f), circles[index(f)])) continue;
    return "the cached circle of a face is not its circle: half-edge";
  }
  return nullptr;
}

}  // namespace apollonius::internal
