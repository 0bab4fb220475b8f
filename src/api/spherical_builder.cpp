#include <optional>
#include <utility>

#include "api/builder.h"
#include "api/spherical_checks.h"
#include "apollonius/spherical_diagram.h"
#include "sphere/projecting.h"

namespace apollonius {

using namespace internal::sphere;

template <>
struct SphericalBuilder::Work {
  explicit Work(SphericalDiagram& diagram) : core(*diagram.core_), sites(diagram.radius()) {}

  [[nodiscard]] std::size_t size() const { return sites.size(); }
  void reserve(std::size_t count) { sites.reserve(count); }
  void add(std::span<const double> more) {
    sites.reserve(more.size() / 3);
    for (std::size_t k = 0; k < more.size(); k += 3)
      (void)sites.take({{more[k], more[k + 1]}, more[k + 2]});
  }

  [[nodiscard]] bool advance(std::size_t steps) {
    if (!projecting) projecting.emplace(sites, core.seed());
    if (!projecting->advance(steps)) return false;
    core.become(std::move(sites), *projecting);
    sites.clear();
    return true;
  }
  [[nodiscard]] double progress() const { return projecting ? projecting->progress() : 0; }

  SphericalCore& core;
  SiteTable sites;
  std::optional<Projecting> projecting;  // of `sites`
  Error error = Error::kNone;            // that ended the work
};

template class BuilderOf<SphericalDiagram>;

}  // namespace apollonius
