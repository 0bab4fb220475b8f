// The sites of a spherical diagram as they were given, by id, and the free ids. Changes can be
// undone in reverse order, without allocating memory.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "apollonius/types.h"
#include "base/flat_array.h"
#include "sphere/cap.h"

namespace apollonius::internal::sphere {

/// Centre in degrees, weight in the unit of the sphere's radius.
struct SphericalSite {
  LonLat centre;
  double r = 0;
};

class SiteTable {
 public:
  /// A table for a sphere of this radius.
  explicit SiteTable(double radius) : radius_(radius) {}

  [[nodiscard]] double radius() const { return radius_; }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] SiteId idLimit() const { return static_cast<SiteId>(rows_.size()); }
  [[nodiscard]] bool has(SiteId id) const { return id < rows_.size() && nextFree_[id] == kUsed; }
  [[nodiscard]] const SphericalSite& operator[](SiteId id) const { return rows_[id]; }
  /// The caps of all sites by id; entries of free ids are undefined. Throws std::bad_alloc.
  [[nodiscard]] FlatArray<Cap> caps() const {
    FlatArray<Cap> caps(idLimit());
    for (SiteId id = 0; id < idLimit(); ++id) {
      if (has(id)) caps[id] = cap(id);
    }
    return caps;
  }
  [[nodiscard]] Cap cap(SiteId id) const { return capOf(rows_[id].centre, rows_[id].r / radius_); }

  /// Makes room for this many more sites. Throws std::bad_alloc.
  void reserve(std::size_t more) {
    const std::size_t slots = std::max(rows_.size(), size_ + more);
    if (slots <= std::min(rows_.capacity(), nextFree_.capacity())) return;
    const std::size_t room = std::max(slots, rows_.size() + rows_.size() / 2);
    rows_.reserve(room);
    nextFree_.reserve(room);
  }
  /// Adds a site with the id that was freed last, or a new one. REQUIRES: room.
  SiteId take(const SphericalSite& site) {
    SiteId id = firstFree_;
    if (id == kNoSite) {
      id = idLimit();
      rows_.push_back(site);
      nextFree_.push_back(kUsed);
    } else {
      firstFree_ = nextFree_[id];
      rows_[id] = site;
      nextFree_[id] = kUsed;
    }
    ++size_;
    return id;
  }
  void release(SiteId id) {
    nextFree_[id] = firstFree_;
    firstFree_ = id;
    --size_;
  }
  /// Undoes the last take(), which returned this id; `limit` is idLimit() before it.
  void undoTake(SiteId id, SiteId limit) {
    if (id < limit) {
      release(id);
    } else {
      rows_.pop_back();
      nextFree_.pop_back();
      --size_;
    }
  }
  /// Undoes the last release(), which released this id.
  void undoRelease(SiteId id) {
    firstFree_ = nextFree_[id];
    nextFree_[id] = kUsed;
    ++size_;
  }
  void set(SiteId id, const SphericalSite& site) { rows_[id] = site; }

  /// Calls visit(id) for the free ids, in the order in which they will be used.
  template <class Visit>
  void visitFree(Visit visit) const {
    for (SiteId id = firstFree_; id != kNoSite; id = nextFree_[id]) visit(id);
  }

  void clear() {
    rows_.clear();
    nextFree_.clear();
    firstFree_ = kNoSite;
    size_ = 0;
  }

 private:
  static constexpr std::uint32_t kUsed = kNoSite - 1;

  double radius_;
  FlatArray<SphericalSite> rows_;      // by id
  FlatArray<std::uint32_t> nextFree_;  // by id: kUsed, or the next free id, or kNoSite at the end
  SiteId firstFree_ = kNoSite;
  std::size_t size_ = 0;
};

}  // namespace apollonius::internal::sphere
