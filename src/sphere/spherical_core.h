// The dynamic diagram of the sphere: the sites by id, and their projection, which is renewed when
// necessary.
// Arguments have been checked by the caller (src/api); lack of memory is thrown as std::bad_alloc
// with the diagram as it was before the call.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "apollonius/types.h"
#include "base/flat_array.h"
#include "sphere/projected_diagram.h"
#include "sphere/projecting.h"
#include "sphere/site_table.h"

namespace apollonius::internal::sphere {

class SphericalCore {
 public:
  explicit SphericalCore(double radius) : sites_(radius) {}

  SiteId insert(const SphericalSite& site);
  /// Adds longitude, latitude, weight triples; ids[k] becomes the id of triple k.
  void insertMany(std::span<const double> sites, std::span<SiteId> ids);
  /// Removes sites. Returns how many of the ids were in use.
  std::size_t removeMany(std::span<const SiteId> ids);
  void update(SiteId id, const SphericalSite& site);
  void updateMany(std::span<const SiteId> ids, std::span<const double> sites);
  void clear() noexcept;
  /// Becomes the diagram of sites that have been projected.
  void become(SiteTable&& sites, Projecting& finished) noexcept;

  [[nodiscard]] const SiteTable& sites() const { return sites_; }
  [[nodiscard]] const ProjectedDiagram& projected() const { return projected_; }
  /// Number of the state: another one after each change.
  [[nodiscard]] std::uint64_t revision() const { return revision_; }
  /// Makes this state the successor of another one of the same diagram.
  void follow(const SphericalCore& before) { revision_ = before.revision_ + 1; }
  /// For drawing the next pole.
  [[nodiscard]] std::uint64_t seed() const { return seed_; }

  /// Writes the sites, the free ids and the pole, from which restore() builds the diagram; replaces
  /// the contents of `bytes`.
  void save(std::vector<std::uint8_t>& bytes) const;
  /// Builds the diagram from the bytes; the sphere gets the radius that was saved. Returns false if
  /// they are no snapshot. REQUIRES: a new diagram, which is unusable after a failure.
  [[nodiscard]] bool restore(std::span<const std::uint8_t> bytes);

  /// The first broken invariant. Throws std::bad_alloc. Cost: O(n), slow: for tests.
  [[nodiscard]] Violation validate() const;

 private:
  friend class Restoring;  // fills a new diagram

  /// Chooses a pole and projects all sites of the table from it.
  void project();
  void take(Projecting& finished) noexcept;
  /// Enters sites that are in the table and in no projection yet.
  void enter(std::span<const SiteId> ids);

  SiteTable sites_;
  ProjectedDiagram projected_;
  std::size_t sizeAtChoice_ = 0;  // the table's size when the pole was chosen
  std::uint64_t seed_ = 1;
  std::uint64_t revision_ = 0;
  FlatArray<SiteId> removed_;        // scratch
  FlatArray<SphericalSite> before_;  // scratch
};

}  // namespace apollonius::internal::sphere
