// The dynamic diagram: the Delaunay graph of the visible sites, the forest of the hidden ones, the
// index for location, and the ids that connect them. Arguments have been checked by the caller
// (src/api); lack of memory is thrown as std::bad_alloc with the diagram as it was before the call.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "apollonius/types.h"
#include "base/flat_array.h"
#include "delaunay/delaunay_graph.h"
#include "delaunay/moves.h"
#include "delaunay/remove.h"
#include "diagram/hidden_forest.h"
#include "diagram/id_pool.h"
#include "diagram/location_index.h"
#include "diagram/transaction.h"

namespace apollonius::internal {

class DiagramCore {
 public:
  explicit DiagramCore(Location location, Naming naming = Naming::kOwn)
      : ids_(naming), index_(location) {}

  /// Inserts a site and returns its id; `given` is the id, if ids are given.
  SiteId insert(const Site& site, SiteId given = kNoSite);
  /// Inserts a site hung directly on `cover`, as its last child: for snapshots of structures built
  /// on a diagram. If it may not hang there, returns false and changes nothing. REQUIRES: ids are
  /// given; the cover's is in use.
  [[nodiscard]] bool insertBelow(const Site& site, SiteId given, SiteId cover);
  /// Makes room for given ids below this limit.
  void reserveIds(std::size_t idLimit) { ids_.reserveIds(idLimit); }

  /// Removes a site. False if the id is not in use.
  bool remove(SiteId id);
  /// Removes sites. Returns how many of the ids were in use.
  std::size_t removeMany(std::span<const SiteId> ids);
  void update(SiteId id, const Site& site);
  void updateMany(std::span<const SiteId> ids, std::span<const double> xyr);
  void clear() noexcept;

  // The steps of a bulk insertion, in this order; BulkInsertion takes them. Nothing else may change
  // the diagram in between. stage(), takeSlot() and the last two do not throw.
  /// Makes room for the circles of this many more sites.
  void reserveStaged(std::size_t more) { delaunay_.reserveSites(slotsWith(more) + 1); }
  /// Copies a circle to one of the slots that ids() gives next.
  void stage(Slot slot, const Site& circle) { delaunay_.setSite(vertexOf(slot), circle); }
  /// Makes room for these sites, and takes an id for each, which `ids` receives, unless it gives
  /// them. The insertion can be rolled back from here on. Returns the argument for attachStaged().
  [[nodiscard]] Undo beginBulk(std::span<SiteId> ids);
  /// Gives this id the next slot, which becomes pending.
  Slot takeSlot(SiteId id) { return ids_.takeSlot(id, SiteState::kPending); }
  /// Makes room in the graph for the sites, which all have slots.
  void reserveAttached(std::size_t more) {
    if (index_.isBulk()) delaunay_.reserveBulk(more);  // for a few, copying all would cost too much
  }
  /// Attaches the site of a pending slot; `start` as for attachSite().
  void attachStaged(Slot slot, VertexId start, Undo undo) {
    const Site circle = site(slot);
    ids_.setState(slot, attachSite(slot, circle, start, undo));
  }
  void endBulk() noexcept { index_.endBulk(delaunay_); }
  /// Instead of endBulk(): detaches the sites of the slots in `attached`, last one first, and frees
  /// all ids. REQUIRES: each id has a slot.
  void rollbackBulk(std::span<const SiteId> ids, std::span<const Slot> attached) noexcept;

  [[nodiscard]] Location location() const { return index_.location(); }
  [[nodiscard]] const IdPool& ids() const { return ids_; }
  [[nodiscard]] std::size_t visibleCount() const { return delaunay_.visibleCount(); }
  [[nodiscard]] const Site& site(Slot slot) const { return delaunay_.site(vertexOf(slot)); }
  [[nodiscard]] const DelaunayGraph& delaunay() const { return delaunay_; }
  [[nodiscard]] const HiddenForest& hidden() const { return hidden_; }
  [[nodiscard]] const LocationIndex& locationIndex() const { return index_; }
  /// Number of the assignment of slots. Sites keep their slots, except when updateMany() builds the
  /// diagram anew; then this number changes.
  [[nodiscard]] std::uint32_t layout() const { return layout_; }

  /// May a site hang on another in the forest? The other covers it and, if the two are identical,
  /// has the lesser id. A strict partial order.
  [[nodiscard]] bool mayHang(Slot child, Slot parent) const {
    return mayHang(child, site(child), parent, site(parent));
  }

  /// The nearest site; `hint` is a visible site close to the point, or kNoSlot. REQUIRES: not
  /// empty.
  [[nodiscard]] Slot nearest(double x, double y, Slot hint = kNoSlot) const;

  /// Writes the diagram as a snapshot; replaces the contents of `bytes`.
  void save(std::vector<std::uint8_t>& bytes) const;
  /// Becomes the diagram that was saved; false if the bytes are no snapshot. REQUIRES: a new
  /// diagram, which is unusable after a failure.
  [[nodiscard]] bool restore(std::span<const std::uint8_t> bytes, Source source);
  /// Has an operation found that trusted bytes were not a valid diagram? Then only clear() may be
  /// called.
  [[nodiscard]] bool isBroken() const { return delaunay_.isBroken(); }

  /// The public id of a vertex's site.
  [[nodiscard]] SiteId siteOf(VertexId v) const { return ids_.idOf(slotOf(v)); }

 private:
  friend class DiagramBreaker;  // tests break a structure on purpose
  friend class Restoring;       // fills a new diagram

  /// Makes room for everything that is kept per site, for this many slots.
  void reserve(std::size_t slots);
  /// Slots in use and free ones, once there are this many more sites.
  [[nodiscard]] std::size_t slotsWith(std::size_t more) const {
    return std::max(ids_.slots(), ids_.size() + more);
  }
  /// Enters a site whose slot is in no structure; `start` is visible, or kNoVertex to locate from
  /// scratch. Returns the state for the slot. May throw.
  [[nodiscard]] SiteState attachSite(Slot slot, const Site& site, VertexId start,
                                     Undo undo = Undo::kNever);
  /// Takes a site out of all structures; its slot becomes pending.
  void detachSite(Slot slot, Undo undo = Undo::kNever);
  /// How a site got to its new place: it was there already; it moved with nothing else changing; or
  /// it was detached and attached.
  enum class Moved : std::uint8_t { kNot, kInPlace, kAnew };
  /// Moves a site. If it cannot be attached anew, it returns to where it was.
  Moved move(Slot slot, const Site& site);
  /// Moves a site if nothing else changes by that; else false.
  [[nodiscard]] bool moveInPlace(Slot slot, const Site& site);
  /// Moves together all sites whose moves change nothing else, or need only flips of edges; the
  /// others stay where they are. If these would be more than `mostLeft`, all may stay. Returns how
  /// many stay, except hidden ones that can be moved in place.
  std::size_t moveManyInPlace(std::span<const SiteId> ids, std::span<const double> xyr,
                              std::span<const std::uint32_t> order, std::size_t mostLeft);
  [[nodiscard]] bool mayHang(Slot child, const Site& childSite, Slot parent,
                             const Site& parentSite) const;
  [[nodiscard]] bool coversChildren(Slot slot, const Site& to) const;
  [[nodiscard]] bool staysBelow(Slot slot, const Site& to) const;
  /// Applies the moves of moves_ that keep the graph, or that flips make right; drops the others.
  /// The levels and the grid follow.
  void makeMoves(Flips flips, std::size_t mostLeft);
  /// Rebuilds the diagram with all sites and these moves made (rebuild.cpp). Returns false, and
  /// changes nothing, if there is no memory for two diagrams.
  [[nodiscard]] bool rebuildWith(std::span<const SiteId> ids, std::span<const double> xyr,
                                 std::span<const std::uint32_t> order) noexcept;
  [[nodiscard]] FlatArray<std::uint32_t> orderOfSlots(std::span<const SiteId> ids) const;
  // Undoing, step by step (transaction.h).
  template <class Step>
  void undoStep(Step step) noexcept;
  void rollbackRemoval(Slot slot, const Site& site) noexcept;
  void rollbackInsertion(Slot slot) noexcept;
  /// Moves a site that has moved in place back.
  void moveBack(Slot slot, const Site& from) noexcept;
  void detachVisible(Slot slot, Undo undo);
  /// Fills the remover's lists with the sites that hang on a visible one: hiddenList() with those
  /// that may become visible, no two of them identical, adoptedList() with the rest.
  void reparentNestedChildren(Slot slot);
  void orderForInsertion(FlatArray<VertexId>& vertices) const;
  /// Links an unlinked site below one that covers it, as a child or deeper. There is room; nothing
  /// throws.
  void link(Slot child, Slot parent) noexcept;
  void saveHidden(WordWriter& out) const;
  [[nodiscard]] bool restoreStates();
  [[nodiscard]] bool restoreHidden(WordReader& in, std::size_t count);

  IdPool ids_;
  DelaunayGraph delaunay_;  // vertex of slot s: s + 1
  HiddenForest hidden_;     // node of slot s: s
  LocationIndex index_;
  Remover remover_;
  SiteMoves siteMoves_;
  FlatArray<SiteMoves::Move> moves_;  // scratch of moves in place
  Transaction transaction_;
  std::uint32_t layout_ = 0;
};

}  // namespace apollonius::internal
