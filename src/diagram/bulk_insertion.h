// Insertion of many sites into a diagram, in one go or in steps.
//
// First the circles are staged: copied to the slots that they will get, along a Hilbert curve, so
// that what is close in the plane is close in memory. The caller can then free its circles, when
// there is little else in memory. Then the sites are inserted, in the order of brioOrder().
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>

#include "base/flat_array.h"
#include "diagram/diagram_core.h"
#include "diagram/spatial_order.h"

namespace apollonius::internal {

/// Inserts all sites or none: an insertion that is not finished when this object is destroyed, or
/// when a step throws std::bad_alloc, is undone. That step is the last one. The diagram must not be
/// changed otherwise in between.
class BulkInsertion {
 public:
  static constexpr std::size_t kAllAtOnce = std::numeric_limits<std::size_t>::max();
  /// Number of visits of a site in stage() that take the time of one insertion: each of the steps
  /// of sorting and copying takes a few nanoseconds, an insertion about a microsecond.
  static constexpr std::size_t kStageVisits = 64;
  /// Number of visits of a site that take the time of this many insertions, `each` for one of them.
  static constexpr std::size_t visits(std::size_t insertions, std::size_t each) {
    return insertions > kAllAtOnce / each ? kAllAtOnce : insertions * each;
  }

  explicit BulkInsertion(DiagramCore& diagram) : diagram_(diagram) {}
  ~BulkInsertion() { undo(); }
  BulkInsertion(const BulkInsertion&) = delete;
  BulkInsertion& operator=(const BulkInsertion&) = delete;

  /// Stages x, y, r triples, at least one, the same ones in all steps; by at most this many visits
  /// of a site. True if all are staged.
  bool stage(std::span<const double> xyr, std::size_t most = kAllAtOnce);

  /// Inserts at most this many of the staged sites; ids[k] becomes the id of circle k, or gives it.
  /// True if all are inserted. `ids` are the same in all steps.
  bool insert(std::span<SiteId> ids, std::size_t most = kAllAtOnce);

  /// The share of the work that is done, 0 to 1, by estimated time.
  [[nodiscard]] double progress() const;

 private:
  void copyStaged(std::span<const double> xyr, std::size_t most);
  /// Does a step of insert(), or as much of it as `most` allows. True if that ended the last step.
  bool goOn(std::span<SiteId> ids, std::size_t most);
  void name(std::size_t most);
  void attach(std::size_t most);
  void undo() noexcept;
  /// The start of the walk of a staged site; kNoVertex: as for a single insertion.
  [[nodiscard]] VertexId startFor(Slot slot) const;

  enum class Step : std::uint8_t { kMakeRoom, kName, kOrder, kAttach };

  DiagramCore& diagram_;
  Step step_ = Step::kMakeRoom;
  std::optional<HilbertSort> sort_;
  FlatArray<std::uint32_t> order_;  // circles in the order of the curve, then slots in theirs
  Slot slot_ = kNoSlot;             // the next circle is copied there
  Slot firstNew_ = 0;      // from here on slots follow the curve; below, free ones are reused
  std::span<SiteId> ids_;  // ids of the sites, once they have some
  std::size_t done_ = 0;   // how many sites have been copied, named, or attached in this step
  Undo undo_ = Undo::kNever;
};

/// Inserts all of at least one x, y, r triple; ids[k] becomes the id of triple k, or gives it.
inline void insertAll(DiagramCore& diagram, std::span<const double> xyr, std::span<SiteId> ids) {
  BulkInsertion insertion(diagram);
  insertion.stage(xyr);
  insertion.insert(ids);
}

}  // namespace apollonius::internal
