// The invariants of a diagram, exactly checked; the first broken one is named with its ids.
#include <cmath>

#include "diagram/diagram_core.h"
#include "diagram/proof.h"
#include "memory/flat_array.h"
#include "predicate/predicates.h"

namespace apollonius {

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
  for (std::size_t i = 0; i < graph_.faceSlots(); ++i) {
    const FaceId f{static_cast<std::uint32_t>(i)};
    where = static_cast<std::uint32_t>(halfedgeOf(f, 0));
    if (!graph_.isLive(f) || agree(circle(f), circles[i])) continue;
    return "the cached circle of a face is not its circle: half-edge";
  }
  return nullptr;
}

Defect DiagramCore::check() const {
  Defect defect;
  if ((defect.what = base_.check(defect.where)) != nullptr) return defect;
  if ((defect.what = hierarchy_.check(base_, defect.where, defect.level)) != nullptr) return defect;
  std::uint32_t used = 0;
  for (Slot slot = 0; slot < ids_.slots(); ++slot) {
    const auto found = [&](const char* what) { return Defect{what, ids_.idOf(slot)}; };
    if ((ids_.state(slot) == SiteState::kVisible) != base_.isVisible(vertexOf(slot))) {
      return found("the state of a site differs from its place in the graph: site");
    }
    if (ids_.state(slot) == SiteState::kFree) continue;
    ++used;
    if (ids_.slotOf(ids_.idOf(slot)) != slot) return found("the place of an id is another: site");
  }
  if (used != ids_.size()) return {"the count of sites is wrong: count", used};
  if (used != ids_.hiddenCount() + base_.visibleCount())
    return {"sites are neither visible nor hidden: count", used};
  return checkHidden();
}

/// Every hidden site hangs on a site that covers it, and all of them hang, at the end, on visible
/// ones.
Defect DiagramCore::checkHidden() const {
  FlatArray<Slot> reached;
  for (Slot slot = 0; slot < ids_.slots(); ++slot) {
    if (ids_.state(slot) == SiteState::kVisible) reached.push_back(slot);
  }
  const std::size_t visible = reached.size();
  for (std::size_t k = 0; k < reached.size(); ++k) {
    for (Slot child = hidden_.firstChild(reached[k]); child != HiddenForest::kNone;
         child = hidden_.nextSibling(child)) {
      const auto found = [&](const char* what) { return Defect{what, ids_.idOf(child)}; };
      if (ids_.state(child) != SiteState::kHidden)
        return found("a site that hangs on another is not hidden: site");
      if (!covers(site(reached[k]), site(child)))
        return found("a hidden site is not covered by its parent: site");
      if (reached.size() == ids_.size())
        return found("the forest of hidden sites has a cycle: site");
      reached.push_back(child);
    }
  }
  if (reached.size() == visible + ids_.hiddenCount()) return {};
  return {"hidden sites hang on nothing: reached", static_cast<std::uint32_t>(reached.size())};
}

}  // namespace apollonius
