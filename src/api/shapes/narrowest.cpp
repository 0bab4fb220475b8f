// The narrowest places of a diagram's edges: a file of its own, as in JavaScript they belong to the
// part with shapes.
#include "api/checks.h"
#include "apollonius/diagram.h"
#include "geometry/clipping/edge_graph.h"

namespace apollonius {

using namespace internal;

Error Diagram::narrowest(VertexArrays& places) const {
  return guarded(*core_, [&] { listNarrowest(*core_, places); });
}

}  // namespace apollonius
