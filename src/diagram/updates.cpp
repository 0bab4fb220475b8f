// Moving sites that keep their ids: in place where that changes no face, together as far as it
// goes, with flips where a few faces change, else one by one, or all anew (rebuild.cpp).
#include <algorithm>

#include "base/flat_array.h"
#include "base/radix_sort.h"
#include "diagram/diagram_core.h"
#include "predicate/predicates.h"

namespace apollonius::internal {

namespace {

// Moving a site on its own, which detaches and attaches it, costs ten to twenty times as much as it
// costs in a bulk insertion, and certifying moves in place half as much: where more than this share
// have to be moved on their own, building anew is cheaper.
constexpr std::size_t kRebuildShare = 48;
constexpr std::size_t kFewMoves = 16;  // are not worth new arrays

}  // namespace

bool DiagramCore::moveInPlace(Slot slot, const Site& site) {
  const Site to = normalized(site);
  if (!coversChildren(slot, to)) return false;
  if (ids_.state(slot) == SiteState::kHidden) {
    if (!staysBelow(slot, to)) return false;
    delaunay_.setSite(vertexOf(slot), to);
    return true;
  }
  if (!delaunay_.graph().hasVertex(vertexOf(slot))) return false;  // the only visible one
  moves_.assign(1, {vertexOf(slot), to});
  makeMoves(Flips::kNone, 1);
  return !moves_.empty();
}

bool DiagramCore::coversChildren(Slot slot, const Site& to) const {
  for (Slot child = hidden_.firstChild(slot); child != HiddenForest::kNone;
       child = hidden_.nextSibling(child)) {
    if (!mayHang(child, site(child), slot, to)) return false;
  }
  return true;
}

/// Does a hidden site's parent cover it at `to`, too? Also returns false if the parent cannot be
/// found quickly.
bool DiagramCore::staysBelow(Slot slot, const Site& to) const {
  const Slot parent = hidden_.isChild(slot) ? hidden_.parentIfNear(slot) : HiddenForest::kNone;
  return parent != HiddenForest::kNone && mayHang(slot, to, parent, site(parent));
}

void DiagramCore::makeMoves(Flips flips, std::size_t mostLeft) {
  const std::span<const std::uint8_t> isMade = siteMoves_.apply(delaunay_, moves_, flips, mostLeft);
  std::size_t made = 0;
  for (std::size_t k = 0; k < moves_.size(); ++k) {
    if (isMade[k] == 0) continue;
    moves_[made++] = moves_[k];
    index_.moved(slotOf(moves_[k].vertex), siteMoves_.siteBefore(k), moves_[k].to);
  }
  moves_.resize(made, {});
  index_.followMoves(delaunay_, moves_, remover_);
}

std::size_t DiagramCore::moveManyInPlace(std::span<const SiteId> ids, std::span<const double> xyr,
                                         std::span<const std::uint32_t> order,
                                         std::size_t mostLeft) {
  moves_.clear();
  moves_.reserve(ids.size());
  std::size_t left = 0;
  for (const std::size_t k : order) {
    const Slot slot = ids_.slotOf(ids[k]);
    const Site to = normalized({xyr[3 * k], xyr[3 * k + 1], xyr[3 * k + 2]});
    const Site& from = site(slot);
    if (areIdentical(from, to)) continue;
    if (delaunay_.graph().hasVertex(vertexOf(slot)) && coversChildren(slot, to)) {
      moves_.push_back({vertexOf(slot), to});
    } else {
      left += ids_.state(slot) != SiteState::kHidden || !staysBelow(slot, to);
    }
  }
  if (left > mostLeft) return left + moves_.size();
  const std::size_t all = moves_.size();
  makeMoves(Flips::kMaybe, mostLeft - left);
  return left + all - moves_.size();
}

void DiagramCore::updateMany(std::span<const SiteId> ids, std::span<const double> xyr) {
  transaction_.begin();
  const FlatArray<std::uint32_t> order = orderOfSlots(ids);
  const std::size_t mostLeft = std::max(ids_.size() / kRebuildShare, kFewMoves);
  FlatArray<Site> before(ids.size());
  for (const std::size_t k : order) before[k] = site(ids_.slotOf(ids[k]));
  FlatArray<Moved> moved(order.size());  // those that were moved one by one, and how
  std::size_t done = 0;
  bool hasFlipped = false;
  Graph graphBefore;  // before the flips, if other changes follow
  const auto steps = [&] {
    const bool isForRebuild = moveManyInPlace(ids, xyr, order, mostLeft) > mostLeft;
    if (isForRebuild && rebuildWith(ids, xyr, order)) return;
    hasFlipped = !isForRebuild && siteMoves_.hasFlipped();
    // From the next change on, the faces that were flipped have other numbers.
    if (hasFlipped && moves_.size() < order.size()) {
      graphBefore = Graph(delaunay_.graph());
      siteMoves_.takeFlipsBack(graphBefore);
    }
    for (; done < order.size(); ++done) {
      const std::size_t k = order[done];
      moved[done] = move(ids_.slotOf(ids[k]), {xyr[3 * k], xyr[3 * k + 1], xyr[3 * k + 2]});
    }
  };
  const auto wayBack = [&] {
    if (isBroken()) return;
    while (done-- > 0) {
      const Slot slot = ids_.slotOf(ids[order[done]]);
      if (moved[done] == Moved::kInPlace) moveBack(slot, before[order[done]]);
      if (moved[done] != Moved::kAnew) continue;
      rollbackInsertion(slot);
      rollbackRemoval(slot, before[order[done]]);
    }
    // Sites that are not back by now have moved together with others, and go back together.
    moves_.clear();
    for (const std::size_t k : order) {
      const Slot slot = ids_.slotOf(ids[k]);
      const Site &from = before[k], &to = site(slot);
      if (areIdentical(from, to)) continue;
      moves_.push_back({vertexOf(slot), from});
      index_.moved(slot, to, from);
    }
    if (hasFlipped) {
      if (graphBefore.isEmpty()) siteMoves_.takeFlipsBack(delaunay_);
      delaunay_.restoreGraph(graphBefore);
    }
    SiteMoves::takeBack(delaunay_, moves_);
  };
  transaction_.run(index_, steps, wayBack);
}

/// Indices into `ids` in the order of the slots, in which close sites follow each other; of an id
/// that is given several times, the last one only.
FlatArray<std::uint32_t> DiagramCore::orderOfSlots(std::span<const SiteId> ids) const {
  FlatArray<Keyed> entries(ids.size());
  for (std::uint32_t k = 0; k < ids.size(); ++k) entries[k] = {ids_.slotOf(ids[k]), k};
  sortByKey(entries);
  FlatArray<std::uint32_t> order;
  order.reserve(ids.size());
  for (std::size_t k = 0; k < entries.size(); ++k) {
    if (k + 1 == entries.size() || entries[k + 1].key != entries[k].key)
      order.push_back(entries[k].value);
  }
  return order;
}

}  // namespace apollonius::internal
