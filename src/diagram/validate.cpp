// The invariants of a diagram, exactly checked; the first broken one is named with its ids.
#include "diagram/diagram_core.h"
#include "memory/flat_array.h"
#include "predicate/predicates.h"

namespace apollonius {

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
