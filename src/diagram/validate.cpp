// The invariants of a diagram, exactly checked; the first broken one is named with its ids.
#include "diagram/validate.h"

#include "base/flat_array.h"
#include "predicate/predicates.h"

namespace apollonius::internal {

namespace {

/// Every hidden site hangs on a site that covers it, and all of them hang, at the end, on visible
/// ones.
Violation checkHidden(const DiagramCore& diagram) {
  const IdPool& ids = diagram.ids();
  const HiddenForest& hidden = diagram.hidden();
  FlatArray<Slot> reached;
  for (Slot slot = 0; slot < ids.slots(); ++slot) {
    if (ids.state(slot) == SiteState::kVisible) reached.push_back(slot);
  }
  const std::size_t visible = reached.size();
  for (std::size_t k = 0; k < reached.size(); ++k) {
    for (Slot child = hidden.firstChild(reached[k]); child != HiddenForest::kNone;
         child = hidden.nextSibling(child)) {
      const auto found = [&](const char* what) { return Violation{what, ids.idOf(child)}; };
      if (ids.state(child) != SiteState::kHidden)
        return found("a site that hangs on another is not hidden: site");
      if (!covers(diagram.site(reached[k]), diagram.site(child)))
        return found("a hidden site is not covered by its parent: site");
      if (reached.size() == ids.size())
        return found("the forest of hidden sites has a cycle: site");
      if (!diagram.mayHang(child, reached[k]))
        return found("a hidden site is identical to its parent and has a lesser id: site");
      reached.push_back(child);
    }
  }
  if (reached.size() == visible + ids.hiddenCount()) return {};
  return {"hidden sites hang on nothing: reached", static_cast<std::uint32_t>(reached.size())};
}

}  // namespace

Violation validate(const DiagramCore& diagram) {
  const IdPool& ids = diagram.ids();
  const DelaunayGraph& delaunay = diagram.delaunay();
  Violation violation;
  if ((violation.what = delaunay.check(violation.where)) != nullptr) return violation;
  if ((violation.what = diagram.locationIndex().levels().check(delaunay, violation.where,
                                                               violation.level)) != nullptr)
    return violation;
  std::uint32_t used = 0;
  for (Slot slot = 0; slot < ids.slots(); ++slot) {
    const auto found = [&](const char* what) { return Violation{what, ids.idOf(slot)}; };
    if ((ids.state(slot) == SiteState::kVisible) != delaunay.isVisible(vertexOf(slot))) {
      return found("the state of a site contradicts the graph: site");
    }
    if (ids.state(slot) == SiteState::kFree) continue;
    ++used;
    if (ids.slotOf(ids.idOf(slot)) != slot) return found("the slot of an id is another: site");
  }
  if (used != ids.size()) return {"the count of sites is wrong: count", used};
  if (used != ids.hiddenCount() + delaunay.visibleCount())
    return {"sites are neither visible nor hidden: count", used};
  return checkHidden(diagram);
}

}  // namespace apollonius::internal
