// The sites around a point one by one, nearest first: for those who cannot say beforehand how many
// they need, such as whoever looks for the nearest ones of some kind.
#pragma once

#include <limits>
#include <memory>

#include "apollonius/diagram.h"
#include "apollonius/export.h"

namespace apollonius {

namespace internal {
class NearbySearch;
}

/// A walk over the sites of a diagram, which must neither change nor end before it.
class APOLLONIUS_EXPORT NearestFirst {
 public:
  /// Nothing is found before start().
  explicit NearestFirst(const Diagram& diagram) noexcept;
  ~NearestFirst();
  NearestFirst(NearestFirst&&) noexcept;

  /// From now on next() gives the sites around (x, y) that are not farther than `maxDistance`,
  /// hidden ones too. Errors: as Diagram::within. Cost: one location.
  [[nodiscard]] Error start(double x, double y,
                            double maxDistance = std::numeric_limits<double>::infinity());

  /// The next site; ties as in Diagram::find, identical circles ascending by id. kNoSite after the
  /// last. Errors: kOutOfMemory; the walk ends with it. Cost: for m sites together O(m log m) with
  /// their neighbours.
  [[nodiscard]] Error next(SiteId& id);

  /// From the point to the site that next() gave last, as Diagram::find has it: so at most 0 if its
  /// circle contains the point. Infinity before the first site and after
  /// the last. O(1).
  [[nodiscard]] double distance() const;

 private:
  const Diagram* diagram_;
  std::unique_ptr<internal::NearbySearch> search_;
};

}  // namespace apollonius
