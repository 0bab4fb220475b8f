// Calls that take many sites or points ask about as many questions of the predicates on every
// distribution as on points spread evenly: outliers, towns, all scales. Work is counted, not timed.
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <ostream>

#include "diagram/bulk_insertion.h"
#include "diagram/diagram_core.h"
#include "diagram/queries.h"
#include "predicate/shadow_check.h"
#include "support/effort.h"
#include "support/generators.h"
#include "support/questions.h"
#include "support/random.h"

namespace apollonius::internal {
namespace {

using namespace test;

/// x and y from 1e-99 to 1e99, but of two magnitudes each.
Circles fewMagnitudes(Random& random, std::size_t n) {
  Circles circles;
  for (std::size_t k = 0; k < n; ++k) {
    const double x = (random.oneIn(2) ? 1 : 1e99) * random.between(0.1, 1);
    const double y = (random.oneIn(2) ? 1e-99 : 1e50) * random.between(0.1, 1);
    circles.push_back({x, y, 0});
  }
  return circles;
}

struct Distribution {
  const char* name;
  std::function<Circles(Random&, std::size_t)> make;
  double most;  ///< questions, against points spread evenly
};

void PrintTo(const Distribution& distribution, std::ostream* out) { *out << distribution.name; }

const std::vector<Distribution>& distributions() {
  static const std::vector<Distribution> all{
      {"OutlierNear", [](Random& r, std::size_t n) { return outlier(r, n, 1e3); }, 1.1},
      {"Outlier", [](Random& r, std::size_t n) { return outlier(r, n, 1e5); }, 1.1},
      {"OutlierFar", [](Random& r, std::size_t n) { return outlier(r, n, 1e9); }, 1.1},
      {"Towns", towns, 1.2},
      {"EveryScale", everyScale, 1.5},
      {"FewMagnitudes", fewMagnitudes, 2},
  };
  return all;
}

struct Sites {
  std::vector<double> xyr, xy;
};

Sites sitesOf(const Circles& circles) {
  Sites sites;
  for (const Circle& c : circles) {
    sites.xyr.insert(sites.xyr.end(), {c.x, c.y, c.r});
    sites.xy.insert(sites.xy.end(), {c.x, c.y});
  }
  return sites;
}

struct Work {
  double building, asking, moving, removing, returning;
};

/// Questions a site.
Work workOf(const Circles& circles) {
  const Sites sites = sitesOf(circles);
  const std::size_t n = circles.size();
  DiagramCore core(Location::kHierarchy);
  std::vector<SiteId> ids(n), found(n);
  Work work{};
  const auto asked = [&](auto&& call) {
    stages::counts() = {};
    call();
    return questions() / static_cast<double>(n);
  };
  work.building = asked([&] { insertAll(core, sites.xyr, ids); });
  constexpr double kAnywhere = std::numeric_limits<double>::infinity();
  work.asking = asked([&] { listNearest(core, sites.xy, kAnywhere, found, {}); });
  // Each site goes where another one was: so all are inserted again.
  std::vector<SiteId> others(ids.begin() + 1, ids.end());
  others.push_back(ids.front());
  work.moving = asked([&] { core.updateMany(others, sites.xyr); });
  // Half of them go and come back, to slots that are free here and there.
  work.removing = asked([&] { core.removeMany({ids.data(), n / 2}); });
  work.returning =
      asked([&] { insertAll(core, {sites.xyr.data(), 3 * (n / 2)}, {ids.data(), n / 2}); });
  return work;
}

class WorkOfBatches : public ::testing::TestWithParam<Distribution> {};

TEST_P(WorkOfBatches, IsThatOnPointsSpreadEvenly) {
  if (kShadowCheck) GTEST_SKIP() << "the shadow check asks on its own account";
  const std::size_t n = sized(20'000, 100'000);
  Random random(351), same(351);
  const Work even = workOf(randomCircles(random, n, Hidden::k5Percent));
  const Work work = workOf(GetParam().make(same, n));
  const double most = GetParam().most;
  EXPECT_LE(work.building, most * even.building);
  EXPECT_LE(work.asking, most * even.asking);
  EXPECT_LE(work.moving, most * even.moving);
  EXPECT_LE(work.removing, most * even.removing);
  EXPECT_LE(work.returning, most * even.returning);
}

INSTANTIATE_TEST_SUITE_P(Distributions, WorkOfBatches, ::testing::ValuesIn(distributions()),
                         [](const auto& parameter) { return parameter.param.name; });

}  // namespace
}  // namespace apollonius::internal
