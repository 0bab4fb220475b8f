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
/// REQUIRES: no two sites have the same centre; with equal weights each cell has a part in the
/// region, as it has if its centre is there.
class APOLLONIUS_EXPORT AreaFit {
 public:
  AreaFit() noexcept;
  ~AreaFit();
  AreaFit(AreaFit&&) noexcept;
  AreaFit& operator=(AreaFit&&) noexcept;

  /// Begins a fit. Targets are by id, in any unit; those of ids without a site are ignored. `start`
  /// has initial weights, likewise by id, or none: then they are equal. Errors: kBadLength unless
  /// there are as many as ids, kBadTarget, kNotFinite and kOutOfRange (start), kBadBounds,
  /// kOutOfMemory. After an error nothing has begun.
  [[nodiscard]] Error begin(const Diagram& diagram, const Region& region,
                            std::span<const double> targets, std::span<const double> start = {});
  /// Makes one step. Errors: kNoConvergence if no step comes closer, kOutOfMemory; then the fit is
  /// as it was. Cost: about that of building the diagram, and of the areas of its cells.
  [[nodiscard]] Error step();
  /// After kNoConvergence: are the weights right up to their last places? Then they can be used,
  /// and error() is what rounding has left.
  [[nodiscard]] bool isAtTheEndOfDoubles() const noexcept;
  /// Largest deviation of an area from its target, as a share of the target; infinite if nothing
  /// has begun. Need not fall with each step.
  [[nodiscard]] double error() const noexcept;
  /// After kBadTarget: the site with that target, or with an empty cell.
  [[nodiscard]] SiteId badSite() const noexcept;
  /// Weights by id; NaN for ids without a site. Replaces the contents. Errors: kOutOfMemory.
  [[nodiscard]] Error weights(std::vector<double>& weights) const;
  /// Gives the weights to the diagram. Errors: kBusy if the diagram has changed since begin(), and
  /// those of Diagram::updateMany.
  [[nodiscard]] Error finish(Diagram& diagram) const;

 private:
  [[nodiscard]] bool isBegun() const noexcept;

  std::unique_ptr<internal::AreaFitState> state_;
};

}  // namespace apollonius
