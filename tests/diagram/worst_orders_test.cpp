// Sorted orders, the classical worst cases of incremental insertion: over all generators and
// spirals, inserted one by one in each of several orders and removed in the same one. Questions to
// the predicates are counted, for n sites and for 4n: per face of the graph that changes they must
// not grow. (The graph itself may change more in one order than in another; that is the price of an
// explicit graph, not of how it is found.)
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "diagram/diagram_core.h"
#include "predicate/shadow_check.h"
#include "support/corpus.h"
#include "support/degree.h"
#include "support/effort.h"
#include "support/questions.h"

namespace apollonius::internal {
namespace {

using test::Circles;
using test::degree;
using test::NamedGenerator;
using test::questions;
using test::Random;
using test::runs;

/// Points on a spiral, without functions that differ between platforms: each step turns by a
/// rational rotation.
Circles spiral(std::size_t n, double growth) {
  constexpr double kCosine = 0.8, kSine = 0.6;
  Circles circles;
  double x = 1, y = 0, radius = 1;
  for (std::size_t k = 0; k < n; ++k) {
    circles.push_back({radius * x, radius * y, 0});
    const double turned = kCosine * x - kSine * y;
    y = kSine * x + kCosine * y;
    x = turned;
    radius += growth / static_cast<double>(n);
  }
  return circles;
}

const std::vector<NamedGenerator>& generators() {
  static const std::vector<NamedGenerator> all = [] {
    std::vector<NamedGenerator> some;
    std::copy_if(test::corpus().begin(), test::corpus().end(), std::back_inserter(some),
                 [](const NamedGenerator& generator) { return generator.large; });
    some.push_back({"SpiralOfFewTurns", [](Random&, std::size_t n) { return spiral(n, 4); }});
    some.push_back({"SpiralOfManyTurns",
                    [](Random&, std::size_t n) { return spiral(n, static_cast<double>(n)); }});
    return some;
  }();
  return all;
}

struct Order {
  const char* name;
  std::function<double(const Circle&)> key;
};

const std::vector<Order>& orders() {
  static const std::vector<Order> all{
      {"as generated", {}},
      {"x ascending", [](const Circle& c) { return c.x; }},
      {"x descending", [](const Circle& c) { return -c.x; }},
      {"y ascending", [](const Circle& c) { return c.y; }},
      {"smallest first", [](const Circle& c) { return c.r; }},
      {"largest first", [](const Circle& c) { return -c.r; }},
  };
  return all;
}

/// Questions per site, and per face that changes where sites have more of them than usual.
struct Work {
  double insertion, removal;
};

Work workOf(const Circles& circles) {
  DiagramCore core(Location::kHierarchy);
  std::vector<SiteId> ids;
  const auto n = static_cast<double>(circles.size());
  const auto perChange = [&](double asked, double faces) { return asked / (faces + 6 * n); };
  Work work{};
  double faces = 0;
  double before = questions();
  for (const Circle& c : circles) {
    ids.push_back(core.insert({c.x, c.y, c.r}));
    faces += static_cast<double>(degree(core, ids.back()));
  }
  work.insertion = perChange(questions() - before, faces);
  faces = 0;
  before = questions();
  for (const SiteId id : ids) {
    faces += static_cast<double>(degree(core, id));
    EXPECT_TRUE(core.remove(id));
  }
  work.removal = perChange(questions() - before, faces);
  return work;
}

class WorstOrders : public ::testing::TestWithParam<NamedGenerator> {};

TEST_P(WorstOrders, AskNoMorePerChangeOfLargerSets) {
  if (kShadowCheck) GTEST_SKIP() << "the shadow check asks on its own account";
  constexpr std::size_t n = 600;  // not a tenth under sanitizers: parallel lines ask too little
  for (const Order& order : orders()) {
    SCOPED_TRACE(order.name);
    Work work[2];
    for (const std::size_t times : {1u, 4u}) {
      Random random(531);
      Circles circles = GetParam().make(random, times * n);
      if (order.key) {
        std::stable_sort(circles.begin(), circles.end(), [&](const Circle& a, const Circle& b) {
          return order.key(a) < order.key(b);
        });
      }
      work[times > 1] = workOf(circles);
    }
    // A quadratic order has four times as much. (Around a giant it depends on luck.)
    EXPECT_LE(work[1].insertion, 3 * work[0].insertion + 2);
    EXPECT_LE(work[1].removal, 3 * work[0].removal + 2);
  }
}

/// A giant over all of them comes and goes: each time all of them become hidden and visible again.
TEST_P(WorstOrders, CoveringAndUncoveringAllCostsWhatTheyAre) {
  if (kShadowCheck) GTEST_SKIP() << "the shadow check asks on its own account";
  const auto n = static_cast<std::size_t>(runs(1000));
  double work[2];
  for (const std::size_t times : {1u, 2u}) {
    Random random(532);
    const Circles circles = GetParam().make(random, times * n);
    DiagramCore core(Location::kHierarchy);
    double reach = 0;
    for (const Circle& c : circles) {
      core.insert({c.x, c.y, c.r});
      reach = std::max({reach, std::abs(c.x), std::abs(c.y), c.r});
    }
    const auto visible = static_cast<double>(core.visibleCount());
    const double before = questions();
    constexpr int kRounds = 5;
    for (int round = 0; round < kRounds; ++round) {
      const SiteId giant = core.insert({0, 0, 8 * reach});
      ASSERT_EQ(core.visibleCount(), 1u);
      ASSERT_TRUE(core.remove(giant));
    }
    ASSERT_EQ(static_cast<double>(core.visibleCount()), visible);
    work[times - 1] = (questions() - before) / (kRounds * static_cast<double>(circles.size()));
  }
  EXPECT_LE(work[1], 1.4 * work[0] + 4);
}

INSTANTIATE_TEST_SUITE_P(Of, WorstOrders, ::testing::ValuesIn(generators()),
                         [](const auto& parameter) { return parameter.param.name; });

}  // namespace
}  // namespace apollonius::internal
