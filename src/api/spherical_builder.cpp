#include "apollonius/spherical_builder.h"

#include <optional>
#include <utility>

#include "api/spherical_checks.h"
#include "sphere/projecting.h"

namespace apollonius {

using namespace internal;
using namespace internal::sphere;

struct SphericalBuilder::Work {
  explicit Work(SphericalCore& diagram) : core(diagram), sites(diagram.sites().radius()) {}

  SphericalCore& core;
  SiteTable sites;
  std::optional<Projecting> projecting;  // of `sites`
  Error error = Error::kNone;            // that ended the work
};

SphericalBuilder::SphericalBuilder(SphericalDiagram& diagram)
    : work_(std::make_unique<Work>(*diagram.core_)) {}
SphericalBuilder::~SphericalBuilder() = default;
SphericalBuilder::SphericalBuilder(SphericalBuilder&&) noexcept = default;

Error SphericalBuilder::reserve(std::size_t count) {
  if (count > kMostSites) return Error::kTooLarge;
  return guarded(work_->core, [&] { work_->sites.reserve(count); });
}

Error SphericalBuilder::add(std::span<const double> sites) {
  if (sites.size() % 3 != 0) return Error::kBadLength;
  SiteTable& all = work_->sites;
  if (const Error error = checkSites(sites, all.radius()); error != Error::kNone) return error;
  if (sites.size() / 3 > kMostSites - all.size()) return Error::kTooLarge;
  return guarded(work_->core, [&] {
    all.reserve(sites.size() / 3);
    for (std::size_t k = 0; k < sites.size(); k += 3)
      (void)all.take({{sites[k], sites[k + 1]}, sites[k + 2]});
  });
}

Error SphericalBuilder::advance(std::size_t steps, bool& isDone) {
  Work& work = *work_;
  isDone = work.error == Error::kNone && work.sites.size() == 0;
  if (isDone || work.error != Error::kNone) return work.error;
  work.error = guarded(work.core, [&] {
    if (!work.projecting) work.projecting.emplace(work.sites, work.core.seed());
    isDone = work.projecting->advance(steps);
    if (!isDone) return;
    work.core.become(std::move(work.sites), *work.projecting);
    work.sites.clear();
  });
  return work.error;
}

double SphericalBuilder::progress() const noexcept {
  return work_->projecting ? work_->projecting->progress() : 0;
}

}  // namespace apollonius
