#include <optional>
#include <utility>

#include "api/builder.h"
#include "api/sphere/spherical_checks.h"
#include "apollonius/spherical_diagram.h"
#include "sphere/projecting.h"
#include "sphere/restoring.h"

namespace apollonius {

using namespace internal::sphere;

template <>
struct SphericalBuilder::Work {
  using Reading = internal::Reading<SphericalCore, internal::sphere::Restoring>;

  explicit Work(SphericalDiagram& built) : diagram(built), sites(diagram.radius()) {}

  [[nodiscard]] SphericalCore& core() const { return *diagram.core_; }
  [[nodiscard]] std::size_t size() const { return sites.size(); }
  void reserve(std::size_t count) { sites.reserve(count); }
  void add(std::span<const double> more) {
    sites.reserve(more.size() / 3);
    for (std::size_t k = 0; k < more.size(); k += 3)
      (void)sites.take({{more[k], more[k + 1]}, more[k + 2]});
  }

  /// The diagram is built of the sites in the bytes, so that nothing has to be proved.
  void read(std::vector<std::uint8_t> bytes, Source) {
    auto empty = std::make_unique<SphericalCore>(diagram.radius());
    reading = std::make_unique<Reading>(std::move(empty), std::move(bytes));
  }
  void become(std::unique_ptr<SphericalCore> restored) { diagram.become(std::move(restored)); }

  [[nodiscard]] bool advance(std::size_t steps) {
    if (!projecting) projecting.emplace(sites, core().seed());
    if (!projecting->advance(steps)) return false;
    core().become(std::move(sites), *projecting);
    sites.clear();
    return true;
  }
  [[nodiscard]] double progress() const { return projecting ? projecting->progress() : 0; }

  SphericalDiagram& diagram;
  SiteTable sites;
  std::optional<Projecting> projecting;  // projects `sites`
  Error error = Error::kNone;            // the one that ended the work
  std::unique_ptr<Reading> reading;
};

template class BuilderOf<SphericalDiagram>;

}  // namespace apollonius
