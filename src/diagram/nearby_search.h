// The sites around a point one by one, in the order of their distance, on the plane and on the
// sphere.
//
// Growing over the graph. Claim: in the order of (distance to p, ties to the larger site), each
// visible site s but the first one has a Delaunay neighbour before it. So the next visible site is
// always among the neighbours of those reported so far.
//   Proof. Ties first: perturb the weights as the canonical rule does (docs/PREDICATES.md,
//   "Degenerate position"), larger sites by infinitely larger amounts. The graph is that of the
//   perturbed sites, the order is that of their distances, no two distances to p are equal, and two
//   cells that meet in a point share an edge. Now walk from p straight to the centre of s. At a
//   point x of the way d(x, s) = d(p, s) - |x - p|, and d(x, u) >= d(p, u) - |x - p| for any other
//   site u (triangle inequality). The way ends in the cell of s, because d(c_s, u) <= d(c_s, s) =
//   -r_s would mean that u covers s; and it does not start there, because s is not the first. Where
//   it enters that cell for the last time, it comes from the cell of a neighbour u with d(x, u) =
//   d(x, s), hence d(p, u) <= d(p, s), and not equal: u is before s.
// The sphere has the triangle inequality and straight ways, too; there the distances are rounded.
//
// Hidden sites: a site that covers s, |c - c_s| <= r - r_s, is nowhere farther than s (triangle
// inequality again) and is larger, or it is identical and has a lesser id. So s comes after its
// parent in the forest, and joins the queue when the parent is reported.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>

#include "apollonius/types.h"
#include "base/flat_array.h"
#include "diagram/id_pool.h"

namespace apollonius::internal {

/// A set of slots whose cost depends on its own size, not on that of the diagram: open addressing,
/// at most half full.
class SlotSet {
 public:
  /// Removes all slots, and keeps the memory.
  void clear() {
    slots_.assign(kLeast, kNoSlot);
    size_ = 0;
  }

  /// Inserts a slot. True if it was not in the set. Throws std::bad_alloc.
  bool insert(Slot slot) {
    if (2 * ++size_ > slots_.size()) grow();
    return write(slot);
  }

 private:
  [[nodiscard]] bool write(Slot slot);
  void grow();

  static constexpr std::size_t kLeast = 256;

  FlatArray<Slot> slots_ = FlatArray<Slot>(kLeast, kNoSlot);
  std::size_t size_ = 0;
};

/// Finds all sites, hidden ones too, in the order of their distance to a point, or those that are
/// not farther than a limit. The diagram must stay as it is. Cost: one location and O(m log m), m =
/// the neighbours of the sites found. Calls throw std::bad_alloc, and must not be repeated then.
///
/// A surface identifies the sites of a diagram by numbers of 32 bits (diagram/plane.h,
/// sphere/nearby.h):
///   Point                          type of a point
///   Site, kNone                    the number of a site, or of none
///   Entry{…, site}                 a site with its sort key
///   nearest(point)                 a nearest site that is visible, or kNone
///   entry(point, site), isAfter(point, entry, other)
///   isBeyond(point, entry, limit)  is it farther than the limit?
///   visitBelow(site, visit)        the hidden sites directly below it
///   visitNeighbors(site, visit)    those of a visible one; may be repeated
///   distance(point, site), contains(point, site), weight(site), idOf(site)
template <class Surface>
class NearbySearch {
 public:
  using Point = typename Surface::Point;
  using Site = typename Surface::Site;
  static constexpr Site kNone = Surface::kNone;

  /// For several points in turn: nothing is found before start().
  explicit NearbySearch(const Surface& surface) : surface_(surface) {}
  NearbySearch(const Surface& surface, const Point& point,
               double maxDistance = std::numeric_limits<double>::infinity())
      : surface_(surface) {
    start(point, maxDistance, surface_.nearest(point));
  }

  /// Begins at a point, in the memory of the search before; `first` is a nearest site that is
  /// visible, or kNone in an empty diagram.
  void start(const Point& point, double maxDistance, Site first);

  /// The next site, kNone after the last.
  [[nodiscard]] Site next();
  /// Its id, kNoSite after the last.
  [[nodiscard]] SiteId nextId() {
    const Site site = next();
    return site == kNone ? kNoSite : surface_.idOf(site);
  }

  // The calls below are about the site that next() gave last.

  /// Its distance; infinite before the first and after the last.
  [[nodiscard]] double distance() const {
    return last_ == kNone ? std::numeric_limits<double>::infinity()
                          : surface_.distance(point_, last_);
  }
  /// Does it contain the point? REQUIRES: there is one.
  [[nodiscard]] bool isInside() const { return surface_.contains(point_, last_); }
  [[nodiscard]] double weight() const { return surface_.weight(last_); }

 private:
  using Entry = typename Surface::Entry;

  [[nodiscard]] auto order() const {
    return [this](const Entry& a, const Entry& b) { return surface_.isAfter(point_, a, b); };
  }
  void consider(Site site);
  /// Considers those that may come directly after a site.
  void follow(Site site);

  Surface surface_;
  Point point_{};
  double maxDistance_ = 0;
  Site last_ = kNone;      // returned last, not followed yet
  FlatArray<Entry> heap_;  // the nearest on top
  SlotSet seen_;           // visible sites only: a hidden one has one parent
  FlatArray<Site> candidates_;
};

template <class Surface>
void NearbySearch<Surface>::start(const Point& point, double maxDistance, Site first) {
  point_ = point;
  maxDistance_ = maxDistance;
  last_ = kNone;
  heap_.clear();
  seen_.clear();
  if (first == kNone) return;
  seen_.insert(first);
  consider(first);
}

template <class Surface>
void NearbySearch<Surface>::consider(Site site) {
  const Entry entry = surface_.entry(point_, site);
  if (surface_.isBeyond(point_, entry, maxDistance_)) return;
  heap_.push_back(entry);
  std::push_heap(heap_.begin(), heap_.end(), order());
}

template <class Surface>
void NearbySearch<Surface>::follow(Site site) {
  surface_.visitBelow(site, [&](Site hidden) { consider(hidden); });
  candidates_.clear();
  surface_.visitNeighbors(site, [&](Site neighbor) {
    if (seen_.insert(neighbor)) candidates_.push_back(neighbor);
  });
  // A loop of its own: sites are fetched from memory side by side.
  for (const Site candidate : candidates_) consider(candidate);
}

template <class Surface>
auto NearbySearch<Surface>::next() -> Site {
  if (last_ != kNone) follow(last_);
  last_ = kNone;
  if (heap_.empty()) return kNone;
  std::pop_heap(heap_.begin(), heap_.end(), order());
  last_ = heap_.back().site;
  heap_.pop_back();
  return last_;
}

}  // namespace apollonius::internal
