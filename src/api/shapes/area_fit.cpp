// AreaFit: checks arguments, translates site ids to indices, and turns lack of memory into an
// error.
#include "apollonius/area_fit.h"

#include <cmath>
#include <limits>
#include <utility>

#include "api/checks.h"
#include "api/shapes/region_state.h"
#include "geometry/cell/area_fitter.h"

namespace apollonius {

using namespace internal;

struct internal::AreaFitState {
  NormalizedPolygon polygon;  // a copy: the region may be destroyed
  AreaFitter fit;
  std::size_t idLimit;
  std::uint64_t diagram;  // number of its state
  SiteId badSite = kNoSite;
  bool isBegun = false;

  AreaFitState(const DiagramCore& core, NormalizedPolygon region, std::uint64_t state)
      : polygon(std::move(region)),
        fit(core, polygon),
        idLimit(core.ids().idLimit()),
        diagram(state) {}
};

AreaFit::AreaFit() noexcept = default;
AreaFit::~AreaFit() = default;
AreaFit::AreaFit(AreaFit&&) noexcept = default;
AreaFit& AreaFit::operator=(AreaFit&&) noexcept = default;

Error AreaFit::begin(const Diagram& diagram, const Region& region, std::span<const double> targets,
                     std::span<const double> start) {
  state_ = nullptr;
  const DiagramCore& core = *diagram.core_;
  if (region.state_ == nullptr) return Error::kBadBounds;
  const std::size_t idLimit = core.ids().idLimit();
  if (targets.size() != idLimit || (!start.empty() && start.size() != idLimit))
    return Error::kBadLength;
  Error error = Error::kNone;
  const Error failed = guarded(core, [&] {
    state_ = std::make_unique<AreaFitState>(core, region.state_->polygon, diagram.state_);
    const std::span<const SiteId> ids = state_->fit.ids();
    FlatArray<double> wanted, from;
    const auto refuse = [&](SiteId id) {
      error = Error::kBadTarget;
      state_->badSite = id;
    };
    for (const SiteId id : ids) {
      if (!isInRange(targets[id]) || !(targets[id] > 0)) return refuse(id);
      wanted.push_back(targets[id]);
      if (start.empty()) continue;
      double weight = start[id];
      error = takeNumber(weight);
      if (error != Error::kNone) return;
      from.push_back(weight);
    }
    const std::uint32_t empty = state_->fit.begin(wanted, from);
    if (empty != AreaFitter::kNone) return refuse(ids[empty]);
    state_->isBegun = true;
  });
  return failed != Error::kNone ? failed : error;
}

bool AreaFit::isBegun() const noexcept { return state_ != nullptr && state_->isBegun; }

Error AreaFit::step() {
  if (!isBegun()) return Error::kNoConvergence;
  try {
    return state_->fit.step() ? Error::kNone : Error::kNoConvergence;
  } catch (const std::bad_alloc&) {
    return Error::kOutOfMemory;
  }
}

bool AreaFit::isAtTheEndOfDoubles() const noexcept {
  return isBegun() && state_->fit.isAtTheEndOfDoubles();
}

double AreaFit::error() const noexcept {
  return isBegun() ? state_->fit.error() : std::numeric_limits<double>::infinity();
}

SiteId AreaFit::badSite() const noexcept { return state_ == nullptr ? kNoSite : state_->badSite; }

Error AreaFit::weights(std::vector<double>& weights) const {
  weights.clear();
  if (!isBegun()) return Error::kNone;
  const AreaFitter& fit = state_->fit;
  try {
    weights.assign(state_->idLimit, std::numeric_limits<double>::quiet_NaN());
    for (std::size_t k = 0; k < fit.ids().size(); ++k) weights[fit.ids()[k]] = fit.weightOf(k);
    return Error::kNone;
  } catch (const std::bad_alloc&) {
  } catch (const std::length_error&) {
  }
  return Error::kOutOfMemory;
}

Error AreaFit::finish(Diagram& diagram) const {
  if (!isBegun()) return Error::kNone;
  if (state_->diagram != diagram.state_) return Error::kBusy;
  FlatArray<double> xyr;
  try {
    xyr = state_->fit.circles();
  } catch (const std::bad_alloc&) {
    return Error::kOutOfMemory;
  }
  const Error error = diagram.updateMany(state_->fit.ids(), xyr);
  // A failed update has been undone: the sites are the same, but the state has another number.
  if (error != Error::kNone) state_->diagram = diagram.state_;
  return error;
}

}  // namespace apollonius
