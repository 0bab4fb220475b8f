// The sites around a point one by one, in the order of their distance.
#pragma once

#include <cstddef>
#include <limits>

#include "base/flat_array.h"
#include "diagram/diagram_core.h"
#include "predicate/distance.h"
#include "predicate/site.h"

namespace apollonius::internal {

/// A set of slots that costs what is put into it, however large the diagram is: open addressing, at
/// most half full.
class SlotSet {
 public:
  /// Takes all out, and keeps the memory.
  void clear() {
    slots_.assign(kLeast, kNoSlot);
    size_ = 0;
  }

  /// Puts it in; was it not there yet? Throws std::bad_alloc.
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

/// All sites, hidden ones too, in the order of their distance to a point, or those that are not
/// farther than a limit; ties as in DiagramCore::nearest(), identical circles ascending by id. The
/// diagram must stay as it is. Cost: one location and O(m log m), m = the neighbours of the sites
/// found. Calls throw std::bad_alloc, and are not to be repeated then.
class NearbySearch {
 public:
  NearbySearch(const DiagramCore& diagram, double x, double y,
               double maxDistance = std::numeric_limits<double>::infinity());
  /// For several points in turn: nothing is found before start().
  explicit NearbySearch(const DiagramCore& diagram) : diagram_(diagram) {}

  /// Begins at a point, in the memory of the search before; returns the nearest site, or kNoSlot in
  /// an empty diagram. `hint`: a visible site close to the point, or kNoSlot.
  Slot start(double x, double y, double maxDistance, Slot hint = kNoSlot);

  /// The next site, kNoSlot after the last.
  [[nodiscard]] Slot next();

  /// To the site that next() gave last; infinity before the first and after the last.
  [[nodiscard]] double distance() const {
    return last_ == kNoSlot ? std::numeric_limits<double>::infinity()
                            : roundedDistance(x_, y_, diagram_.site(last_));
  }

 private:
  /// A site that may come next.
  struct Entry {
    double distance;
    double bound;  // of its error
    Slot slot;
  };

  [[nodiscard]] bool isAfter(const Entry& a, const Entry& b) const;
  void consider(Slot slot);
  /// Considers those that may come directly after a site.
  void follow(Slot slot);

  const DiagramCore& diagram_;
  double x_ = 0, y_ = 0;
  double maxDistance_ = 0;
  Slot last_ = kNoSlot;    // returned last, not followed yet
  FlatArray<Entry> heap_;  // the nearest on top
  SlotSet seen_;           // of visible sites: a hidden one has one parent
  FlatArray<Slot> candidates_;
};

}  // namespace apollonius::internal
