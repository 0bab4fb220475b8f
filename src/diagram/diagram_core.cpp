#include "diagram/diagram_core.h"

#include <algorithm>
#include <new>

#include "base/flat_array.h"
#include "base/function_ref.h"
#include "base/radix_sort.h"
#include "diagram/spatial_order.h"
#include "number/invariant.h"
#include "predicate/predicates.h"

namespace apollonius::internal {

namespace {

/// May the child hang on the parent?
struct MayHang {
  const DiagramCore& core;
  bool operator()(Slot parent, Slot child) const { return core.mayHang(child, parent); }
};

}  // namespace

void DiagramCore::reserve(std::size_t slots) {
  ids_.reserve(slots);
  hidden_.reserve(slots);
  delaunay_.reserve(slots + 1);  // last: its size tells whether there is room
}

Slot DiagramCore::nearest(double x, double y, Slot hint) const {
  const VertexId start = hint != kNoSlot ? vertexOf(hint) : index_.startFor(delaunay_, x, y);
  return slotOf(delaunay_.locate(x, y, start, index_.walk()).nearest);
}

bool DiagramCore::mayHang(Slot child, const Site& childSite, Slot parent,
                          const Site& parentSite) const {
  return covers(parentSite, childSite) &&
         (!areIdentical(parentSite, childSite) || ids_.idOf(parent) < ids_.idOf(child));
}

SiteId DiagramCore::insert(const Site& site, SiteId given) {
  const Slot slot = ids_.next();
  if (slot + std::size_t{2} > delaunay_.graph().vertexSlots()) {
    hidden_.reserve(slot + std::size_t{1});
    delaunay_.reserve(slot + std::size_t{2});  // last: see reserve
  }
  const SiteId id = ids_.take(SiteState::kPending, given);
  try {
    ids_.setState(slot, attachSite(slot, site, kNoVertex));
  } catch (...) {
    ids_.release(slot);
    throw;
  }
  return id;
}

bool DiagramCore::insertBelow(const Site& site, SiteId given, SiteId cover) {
  const Slot slot = ids_.next();
  reserve(slot + std::size_t{1});
  hidden_.reserveChildren(1);
  delaunay_.setSite(vertexOf(slot), normalized(site));
  (void)ids_.take(SiteState::kPending, given);
  const Slot parent = ids_.slotOf(cover);
  if (!mayHang(slot, parent)) {
    ids_.release(slot);
    return false;
  }
  hidden_.attach(slot, parent);
  ids_.setState(slot, SiteState::kHidden);
  return true;
}

SiteState DiagramCore::attachSite(Slot slot, const Site& site, VertexId start, Undo undo) {
  const VertexId v = vertexOf(slot);
  delaunay_.setSite(v, normalized(site));
  if (start == kNoVertex) start = index_.startFor(delaunay_, site.x, site.y);
  DelaunayGraph::Insertion insertion = delaunay_.prepareInsertion(v, start, index_.walk());
  if (insertion.cover != kNoVertex) {
    if (mayHang(slot, slotOf(insertion.cover))) {
      hidden_.reserveChildren(1);
      link(slot, slotOf(insertion.cover));
      return SiteState::kHidden;
    }
    insertion = delaunay_.prepareReplacing(v, insertion.cover);
  }
  hidden_.reserveChildren(insertion.mostCovered);
  if (undo == Undo::kMaybe) {
    remover_.reserve(insertion.degree + insertion.mostCovered);
    delaunay_.reserveReturn(insertion.returnRoom);
  }
  // From here on nothing throws. None of these covers another: they were visible.
  for (const VertexId covered : delaunay_.insertPrepared(v)) {
    hidden_.attach(slotOf(covered), slot);
    ids_.setState(slotOf(covered), SiteState::kHidden);
    index_.left(slotOf(covered), delaunay_.site(covered), remover_);
  }
  index_.entered(delaunay_, slot);
  return SiteState::kVisible;
}

bool DiagramCore::remove(SiteId id) {
  const Slot slot = ids_.slotOf(id);
  if (slot == kNoSlot) return false;
  detachSite(slot);
  ids_.release(slot);
  return true;
}

std::size_t DiagramCore::removeMany(std::span<const SiteId> ids) {
  transaction_.begin();
  FlatArray<Slot> gone;
  gone.reserve(ids.size());
  transaction_.run(
      index_,
      [&] {
        for (const SiteId id : ids) {
          const Slot slot = ids_.slotOf(id);
          if (slot == kNoSlot || ids_.state(slot) == SiteState::kPending)
            continue;  // pending: repeated
          detachSite(slot, Undo::kMaybe);
          gone.push_back(slot);
        }
      },
      [&] {
        for (std::size_t k = gone.size(); k-- > 0;) rollbackRemoval(gone[k], site(gone[k]));
      });
  for (const Slot slot : gone) ids_.release(slot);
  return gone.size();
}

void DiagramCore::detachSite(Slot slot, Undo undo) {
  if (ids_.state(slot) == SiteState::kHidden) {
    invariant(hidden_.isChild(slot), "a hidden site hangs on another");
    // Its children may hang on its parent, too.
    hidden_.dissolve(slot, MayHang{*this});
  } else {
    detachVisible(slot, undo);
  }
  ids_.setState(slot, SiteState::kPending);
}

void DiagramCore::link(Slot child, Slot parent) noexcept {
  hidden_.link(child, parent, MayHang{*this});
}

void DiagramCore::detachVisible(Slot slot, Undo undo) {
  reparentNestedChildren(slot);
  const FlatArray<VertexId>& children = remover_.hiddenList();
  const std::span<const Remover::Outcome> adopted(remover_.adoptedList().data(),
                                                  remover_.adoptedList().size());
  const std::span<const Remover::Outcome> outcomes =
      remover_.remove(delaunay_, vertexOf(slot), children, undo == Undo::kMaybe);
  // From here on nothing throws.
  for (const std::span<const Remover::Outcome> all : {adopted, outcomes}) {
    for (const Remover::Outcome& outcome : all) {
      const Slot child = slotOf(outcome.vertex);
      hidden_.detach(child);
      if (outcome.cover == kNoVertex) {
        ids_.setState(child, SiteState::kVisible);
      } else {
        link(child, slotOf(outcome.cover));
      }
    }
  }
  index_.left(slot, site(slot), remover_);
  // The outcomes were the remover's scratch, which the line above may have used.
  for (const VertexId child : children) {
    if (ids_.state(slotOf(child)) == SiteState::kVisible) index_.entered(delaunay_, slotOf(child));
  }
}

/// Among identical children, the one with the least id adopts the others. Then the largest adopts
/// all children that it covers: a question each, while the remover locates each that it gets. That
/// goes on with the largest of the rest as long as a quarter of them is adopted: at most four
/// questions a child.
void DiagramCore::reparentNestedChildren(Slot slot) {
  FlatArray<VertexId>& children = remover_.hiddenList();
  FlatArray<Remover::Outcome>& adopted = remover_.adoptedList();
  children.clear();
  adopted.clear();
  for (Slot child = hidden_.firstChild(slot); child != HiddenForest::kNone;
       child = hidden_.nextSibling(child)) {
    children.push_back(vertexOf(child));
  }
  adopted.reserve(children.size());
  const auto compare = [this](VertexId a, VertexId b) {
    const Site &siteA = delaunay_.site(a), &siteB = delaunay_.site(b);
    return areIdentical(siteA, siteB) ? siteOf(a) < siteOf(b) : precedes(siteB, siteA);
  };
  const FunctionRef<bool(VertexId, VertexId)> isBefore(compare);
  // With a tenth of the code of std::sort.
  std::make_heap(children.begin(), children.end(), isBefore);
  std::sort_heap(children.begin(), children.end(), isBefore);
  VertexId* kept = children.begin();
  for (const VertexId child : children) {
    if (kept != children.begin() && areIdentical(delaunay_.site(kept[-1]), delaunay_.site(child))) {
      adopted.push_back({child, kept[-1]});
    } else {
      *kept++ = child;
    }
  }
  children.resize(static_cast<std::size_t>(kept - children.begin()));
  for (std::size_t done = 0; done + 1 < children.size(); ++done) {
    VertexId* const first = children.begin() + done;
    const VertexId largest = *first;
    const auto isAdopted = [&](VertexId child) {
      const bool isCovered = covers(delaunay_.site(largest), delaunay_.site(child));
      if (isCovered) adopted.push_back({child, largest});
      return isCovered;
    };
    VertexId* const end = std::remove_if(first + 1, children.end(), isAdopted);
    const auto rest = children.end() - first, count = children.end() - end;
    children.resize(static_cast<std::size_t>(end - children.begin()));
    if (4 * count < rest) break;
  }
  orderForInsertion(children);
}

/// Many are tried in the order of a bulk insertion; in any other one walks would be long. So they
/// are where there is no room for that order, as when this undoes an operation that ran out of
/// memory.
void DiagramCore::orderForInsertion(FlatArray<VertexId>& vertices) const {
  constexpr std::size_t kMany = 32;
  if (vertices.size() < kMany) return;
  try {
    FlatArray<double> centres;
    centres.reserve(2 * vertices.size());
    for (const VertexId v : vertices) {
      centres.push_back(delaunay_.site(v).x);
      centres.push_back(delaunay_.site(v).y);
    }
    const FlatArray<std::uint32_t> order = brioOrder(hilbertOrder({centres, 2}));
    FlatArray<VertexId> ordered;
    ordered.reserve(vertices.size());
    for (const std::uint32_t k : order) ordered.push_back(vertices[k]);
    std::copy(ordered.begin(), ordered.end(), vertices.begin());
  } catch (const std::bad_alloc&) {
    return;
  }
}

void DiagramCore::update(SiteId id, const Site& site) { move(ids_.slotOf(id), site); }

DiagramCore::Moved DiagramCore::move(Slot slot, const Site& site) {
  const Site old = this->site(slot);
  if (areIdentical(old, site)) return Moved::kNot;
  transaction_.begin();
  if (moveInPlace(slot, site)) return Moved::kInPlace;
  detachSite(slot, Undo::kMaybe);
  transaction_.run(
      index_, [&] { ids_.setState(slot, attachSite(slot, site, kNoVertex, Undo::kMaybe)); },
      [&] { rollbackRemoval(slot, old); });
  return Moved::kAnew;
}

void DiagramCore::moveBack(Slot slot, const Site& from) noexcept {
  const SiteMoves::Move move{vertexOf(slot), from};
  if (ids_.state(slot) == SiteState::kVisible) index_.moved(slot, site(slot), from);
  SiteMoves::takeBack(delaunay_, {&move, 1});
}

/// Where invalid trusted bytes made the diagram, going back can fail: it is broken then, and left
/// as it is.
template <class Step>
void DiagramCore::undoStep(Step step) noexcept {
  if (isBroken()) return;
  try {
    step();
  } catch (const std::bad_alloc&) {
    invariant(isBroken(), "there is room to undo");
  }
}

void DiagramCore::rollbackRemoval(Slot slot, const Site& site) noexcept {
  undoStep([&] { ids_.setState(slot, attachSite(slot, site, kNoVertex)); });
}

void DiagramCore::rollbackInsertion(Slot slot) noexcept {
  undoStep([&] { detachSite(slot); });
}

void DiagramCore::clear() noexcept {
  delaunay_.clear();
  hidden_.clear();
  index_.clear();
  ids_.clear();
}

}  // namespace apollonius::internal
