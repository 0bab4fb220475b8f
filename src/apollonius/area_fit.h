// Weights for which the cells inside a region have prescribed areas: capacities of facilities,
// Voronoi treemaps.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "apollonius/diagram.h"
#include "apollonius/export.h"
#include "apollonius/region.h"

namespace apollonius {

namespace internal {
struct AreaFitState;
}

/// Changes the weights of all sites of a diagram so that the areas of their cells inside a region
/// are in proportion to targets; centres stay, and hidden sites get a cell, too. Newton's method on
/// a diagram of its own: begin(), step() until error() is small enough, finish(). Up to then the
/// diagram is as it was.
///
/// Two sites may not have one centre; and with equal weights each cell must have a part in the
/// region, as it has if its centre is there.
class APOLLONIUS_EXPORT AreaFit {
 public:
  AreaFit() noexcept;
  ~AreaFit();
  AreaFit(AreaFit&&) noexcept;
  AreaFit& operator=(AreaFit&&) noexcept;

  /// Targets by id, in any unit, those of ids without a site being ignored; so are the weights to
  /// start from, of which there may be none (then equal ones). Errors: kBadLength unless there are
  /// as many as ids, kBadTarget, kNotFinite and kOutOfRange (start), kBadBounds, kOutOfMemory. Then
  /// nothing has been begun.
  [[nodiscard]] Error begin(const Diagram& diagram, const Region& region,
                            std::span<const double> targets, std::span<const double> start = {});
  /// One step. Errors: kNoConvergence if none comes closer, kOutOfMemory; the fit is as it was
  /// then. Cost: about that of building the diagram, and of the areas of its cells.
  [[nodiscard]] Error step();
  /// After kNoConvergence: are the weights those looked for, up to their last places? Then they can
  /// be taken, and error() says what rounding has left.
  [[nodiscard]] bool isAtTheEndOfDoubles() const noexcept;
  /// The largest deviation of an area from what it is to be, as a share of that; infinite if
  /// nothing has been begun. Need not fall with each step.
  [[nodiscard]] double error() const noexcept;
  /// After kBadTarget: the site with that target, or with an empty cell.
  [[nodiscard]] SiteId badSite() const noexcept;
  /// By id; NaN for ids without a site. Replaces the contents. Errors: kOutOfMemory.
  [[nodiscard]] Error weights(std::vector<double>& weights) const;
  /// Gives the weights to the diagram. Errors: kBusy if that has changed since begin(), and those
  /// of Diagram::updateMany.
  [[nodiscard]] Error finish(Diagram& diagram) const;

 private:
  [[nodiscard]] bool isBegun() const noexcept;

  std::unique_ptr<internal::AreaFitState> state_;
};

}  // namespace apollonius
