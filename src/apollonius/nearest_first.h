// The sites around a point one by one, nearest first: for callers that do not know beforehand how
// many they need, as in a search for the nearest sites of some kind.
#pragma once

#include <limits>
#include <memory>

#include "apollonius/diagram.h"
#include "apollonius/export.h"

namespace apollonius {

class SphericalDiagram;

/// A walk over the sites of a Diagram or a SphericalDiagram, which must neither change nor end
/// before it.
template <class AnyDiagram>
class APOLLONIUS_EXPORT NearestFirstOf {
 public:
  /// Finds nothing before start().
  explicit NearestFirstOf(const AnyDiagram& diagram) noexcept;
  ~NearestFirstOf();
  NearestFirstOf(NearestFirstOf&&) noexcept;

  /// Starts a walk: next() gives the sites around (x, y), on the sphere longitude and latitude,
  /// that are not farther than `maxDistance`, hidden ones too. Errors: as within() and kNearest()
  /// of the diagram. Cost: one location.
  [[nodiscard]] Error start(double x, double y,
                            double maxDistance = std::numeric_limits<double>::infinity());

  /// The next site; ties as in kNearest(). kNoSite after the last. Errors: kOutOfMemory; the walk
  /// ends with it. Cost: for m sites together O(m log m) with their neighbours.
  [[nodiscard]] Error next(SiteId& id);

  /// The distance from the point to the site that next() gave last, as find() gives it: so at most
  /// 0 if its circle contains the point. Infinity before the first site and after the last. O(1).
  [[nodiscard]] double distance() const;

 private:
  struct Search;

  const AnyDiagram* diagram_;
  std::unique_ptr<Search> search_;
};

using NearestFirst = NearestFirstOf<Diagram>;
using SphericalNearestFirst = NearestFirstOf<SphericalDiagram>;

}  // namespace apollonius
