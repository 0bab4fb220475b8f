// Vertices as everybody gets them: the nearest doubles, at every scale, and where a quotient is
// next to the middle of two of them.
#include "predicate/precise_circle.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>

#include "number/dyadic.h"
#include "number/root_sign.h"
#include "predicate/compute_circle.h"
#include "predicate/long_kernels.h"
#include "predicate/predicates.h"
#include "predicate/reference_site.h"
#include "support/effort.h"
#include "support/random.h"

namespace apollonius::internal {
namespace {

using test::Random;

Dyadic magnitude(const Dyadic& x) { return x.sign() == Sign::kNegative ? -x : x; }

struct Triangle {
  std::array<Site, 3> sites;

  /// Exact numbers: twice the turn, and the centre's coordinates times that.
  struct Exact {
    Dyadic x, y, twice;
  };
  [[nodiscard]] Exact exact() const {
    std::array<Dyadic, 3> x, y;
    for (std::size_t k = 0; k < 3; ++k) x[k] = Dyadic(sites[k].x), y[k] = Dyadic(sites[k].y);
    const Dyadic turn = (x[1] - x[0]) * (y[2] - y[0]) - (y[1] - y[0]) * (x[2] - x[0]);
    Exact result{Dyadic(0), Dyadic(0), turn + turn};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3, last = (k + 2) % 3;
      const Dyadic squares = x[k] * x[k] + y[k] * y[k];
      result.x = result.x + squares * (y[next] - y[last]);
      result.y = result.y + squares * (x[last] - x[next]);
    }
    return result;
  }
  [[nodiscard]] VoronoiCircle circle() const {
    return commonVoronoiCircle(sites[0], sites[1], sites[2]);
  }
};

/// Is no other double nearer to over / under, and of two the one of even mantissa taken?
void expectNearest(double value, const Dyadic& over, const Dyadic& under) {
  const auto off = [&](double v) { return magnitude(over - Dyadic(v) * under); };
  for (const double other : {std::nextafter(value, HUGE_VAL), std::nextafter(value, -HUGE_VAL)}) {
    const Sign further = (off(other) - off(value)).sign();
    EXPECT_NE(further, Sign::kNegative) << value << ", but " << other << " is nearer";
    if (further == Sign::kZero && value != 0) {
      EXPECT_GT(lowestExponentOf(value), lowestExponentOf(other)) << value << " is odd";
    }
  }
}

void expectNearest(const Triangle& triangle) {
  const Triangle::Exact exact = triangle.exact();
  ASSERT_EQ(exact.twice.sign(), Sign::kPositive);
  const VoronoiCircle circle = triangle.circle();
  expectNearest(circle.x, exact.x, exact.twice);
  expectNearest(circle.y, exact.y, exact.twice);
}

/// Sites at integer distances from an integer point that touch a circle of integer radius there.
TEST(PreciseCircle, OfIntegersIsOfIntegersWhereItCanBe) {
  constexpr std::array<std::array<double, 3>, 8> kTriples{{{3, 4, 5},
                                                           {-5, 12, 13},
                                                           {-15, -8, 17},
                                                           {7, -24, 25},
                                                           {20, 21, 29},
                                                           {1, 0, 1},
                                                           {0, -1, 1},
                                                           {-12, 35, 37}}};
  Random random(176);
  int count = 0;
  for (int run = 0; run < test::runs(20000); ++run) {
    const auto x = static_cast<double>(random.integer(-300, 300)),
               y = static_cast<double>(random.integer(-300, 300)),
               s = static_cast<double>(random.integer(-20, 100));
    std::array<Site, 3> sites;
    for (Site& site : sites) {
      const auto& [dx, dy, length] = kTriples[random.below(kTriples.size())];
      const auto times = static_cast<double>(random.integer(1, 8));
      site = {x + times * dx, y + times * dy, times * length - s};
    }
    const auto& [a, b, c] = sites;
    const bool areInLine = (b.x - a.x) * (c.y - a.y) == (b.y - a.y) * (c.x - a.x);
    if (areInLine || !hasVoronoiCircle(a, b, c)) continue;
    const VoronoiCircle circle = preciseVoronoiCircle(&a, &b, &c);
    if (circle.s != s) continue;  // the three touch two circles: this is the other one
    ++count;
    EXPECT_EQ(circle.x, x) << run;
    EXPECT_EQ(circle.y, y) << run;
  }
  EXPECT_GT(count, test::runs(2000));
}

/// A coordinate that is zero while nothing else is short: what sums of two doubles leave of it.
TEST(PreciseCircle, OnAnAxisOfSymmetryIsThere) {
  Random random(178);
  int count = 0;
  for (int run = 0; run < test::runs(3000); ++run) {
    const auto number = [&] { return static_cast<double>(random.integer(1, 1000)); };
    const double x = number(), y = number(), r = number();
    const Site left{-x, y, r}, right{x, y, r}, low{0, -number(), number()};
    if (covers(left, right) || covers(left, low) || covers(low, left) ||
        !hasVoronoiCircle(left, low, right))
      continue;
    ++count;
    EXPECT_EQ(preciseVoronoiCircle(&left, &low, &right).x, 0) << run;
  }
  EXPECT_GT(count, test::runs(1000));
}

/// A face's vertex in exact numbers: its coordinates are those of the reference site and
/// p (first + second √d) / 2c, as in bounded_center.h.
class ExactCenter {
 public:
  ExactCenter(Corner i, Corner j, Corner k) {
    rotateToReference(i, j, k);
    x_ = Dyadic(i->x), y_ = Dyadic(i->y);
    const ExactKernel kernel(*i, {j, k});
    const Row<Dyadic> a = kernel.row(0), b = kernel.row(1);
    const auto [u, v, w] = chordOf(a, b);
    p_ = a.p;
    n_ = u * u + v * v;
    d_ = n_ - w * w;
    alongX_ = {-(w * u), v};
    alongY_ = {-(w * v), -u};
    c_ = {n_ * a.r - w * (u * a.x + v * a.y), v * a.x - u * a.y};
  }
  void expectNearest(const VoronoiCircle& circle, int run) const {
    expectBetween(alongX_, x_, circle.x, "x", run);
    expectBetween(alongY_, y_, circle.y, "y", run);
  }

 private:
  struct Number {
    Dyadic first, second;
  };

  /// Is the coordinate between the middles of `value` and the doubles beside it?
  void expectBetween(const Number& number, const Dyadic& beside, double value, const char* what,
                     int run) const {
    for (const double end : {-HUGE_VAL, HUGE_VAL}) {
      const Dyadic middle =
          (Dyadic(value) + Dyadic(std::nextafter(value, end))) * Dyadic(0.5) - beside;
      const Dyadic twice = middle + middle;
      const Sign sign = signOfRoot(number.first * p_ - c_.first * twice,
                                   number.second * p_ - c_.second * twice, d_);
      EXPECT_NE(sign, end > 0 ? Sign::kPositive : Sign::kNegative) << what << ", run " << run;
    }
  }

  Dyadic x_, y_, p_, n_, d_;
  Number alongX_, alongY_, c_;
};

TEST(PreciseCircle, OfIntegersHasTheNearestDoublesWhateverTheWeights) {
  Random random(177);
  int count = 0;
  for (int run = 0; run < test::runs(20000); ++run) {
    const std::int64_t most = std::int64_t{1} << (3 + run % 14);
    const double far = run % 3 == 0 ? std::ldexp(1.0, 20 + run % 31) : 0;
    const auto number = [&] { return static_cast<double>(random.integer(-most, most)); };
    std::array<Site, 3> s;
    for (Site& site : s)
      site = {far + number(), number() - far, static_cast<double>(random.integer(0, most / 2))};
    if (covers(s[0], s[1]) || covers(s[1], s[0]) || covers(s[1], s[2]) || covers(s[2], s[1]) ||
        covers(s[0], s[2]) || covers(s[2], s[0]) || !hasVoronoiCircle(s[0], s[1], s[2]))
      continue;
    ++count;
    ExactCenter(&s[0], &s[1], &s[2]).expectNearest(preciseVoronoiCircle(&s[0], &s[1], &s[2]), run);
    if (::testing::Test::HasFailure()) return;
  }
  EXPECT_GT(count, test::runs(2000));
}

/// Integers too long for the formulas in doubles, most of them in flat triangles.
TEST(PreciseCircle, OfLongIntegersHasTheNearestDoubles) {
  Random random(171);
  int count = 0;
  for (int run = 0; run < test::runs(2000); ++run) {
    const std::int64_t most = std::int64_t{1} << (18 + run % 30);
    const auto number = [&] { return static_cast<double>(random.integer(-most, most)); };
    Triangle t{{Site{number(), number(), 0}, {number(), number(), 0}, {number(), number(), 0}}};
    if (run % 2 == 0) {  // nearly in line
      auto& [a, b, c] = t.sites;
      const double dx = b.x - a.x, dy = b.y - a.y;
      c.x = a.x + 2 * dx + static_cast<double>(random.integer(-2, 2));
      c.y = a.y + 2 * dy + static_cast<double>(random.integer(-2, 2));
    }
    if (t.exact().twice.sign() != Sign::kPositive) continue;
    ++count;
    expectNearest(t);
    if (::testing::Test::HasFailure()) FAIL() << "run " << run;
  }
  EXPECT_GT(count, test::runs(500));
}

/// Far from the origin doubles are as far apart as integers: quotients are ties, or next to one.
TEST(PreciseCircle, TiesGoToTheEvenDouble) {
  constexpr double kFar = 0x1p52;
  for (double first = kFar + 1; first < kFar + 9; ++first) {
    for (double width = 1; width < 8; ++width) {
      expectNearest(Triangle{{Site{first, 0, 0}, {first + width, 0, 0}, {first, 4, 0}}});
      expectNearest(Triangle{{Site{0, first, 0}, {4, first, 0}, {0, first + width, 0}}});
      expectNearest(Triangle{{Site{-first, 0, 0}, {-first, -4, 0}, {width - first, 0, 0}}});
    }
  }
}

/// Found by a search: 2^-20 beside a tie, which the estimate cannot tell from one.
TEST(PreciseCircle, NextToATieTheNearerDoubleIsTaken) {
  constexpr double kFar = 0x1p52 + 5000;
  for (const auto& [jx, jy, kx, ky] : {std::array{844.0, 497.0, -824.0, 774.0},
                                       {981.0, 674.0, -810.0, 619.0},
                                       {915.0, -979.0, 861.0, 304.0}}) {
    expectNearest(Triangle{{Site{kFar, 0, 0}, {kFar + jx, jy, 0}, {kFar + kx, ky, 0}}});
    expectNearest(Triangle{{Site{-kFar, 0, 0}, {-kFar - jx, -jy, 0}, {-kFar - kx, -ky, 0}}});
    expectNearest(Triangle{{Site{kFar + 1, 0, 0}, {kFar + 1 + jx, jy, 0}, {kFar + 1 + kx, ky, 0}}});
  }
}

/// With (1 + e, 1/2) for the third site the centre is at 1/4 + e + e², and e is chosen so that e²
/// ends a little before or behind the middle of two doubles; on no grid of few digits.
TEST(PreciseCircle, NextToATieOffTheGridTheNearerDoubleIsTaken) {
  for (const double m : {4490139.0, 6766411.0, 10573681.0, 12412817.0, 13838057.0, 16777213.0})
    expectNearest(Triangle{{Site{0, 0, 0}, {1, 0, 0}, {1 + m * 0x1p-40, 0.5, 0}}});
}

/// With (p, first + 1) for the third site the centre is at y = first + 1/2 - p (1 - p) / 2: beside
/// the middle of two doubles by less than numbers of twice the digits can tell.
TEST(PreciseCircle, NextToNothingBesideATieTheNearerDoubleIsTaken) {
  for (const double first : {0x1p52 + 1, 0x1p52 + 2, -0x1p52 - 1, -0x1p52 - 4}) {
    for (const int exponent : {-70, -110, -200, -330}) {
      for (const double p : {std::ldexp(1.0, exponent), -std::ldexp(1.0, exponent)}) {
        expectNearest(Triangle{{Site{0, first, 0}, {1, first, 0}, {p, first + 1, 0}}});
        expectNearest(Triangle{{Site{first, 0, 0}, {first + 1, p, 0}, {first, 1, 0}}});
      }
    }
  }
}

/// About the origin, from far away: the estimate to begin with has no right digit.
TEST(PreciseCircle, NextToTheOriginHasTheNearestDoubles) {
  Random random(174);
  for (int run = 0; run < test::runs(300); ++run) {
    const double radius = std::ldexp(1.0, 20 + run % 31);
    Triangle t;
    for (std::size_t k = 0; k < 3; ++k) {  // in thirds of the circle
      const double half = random.between(0.1, 0.5), norm = 1 + half * half;
      const double x = radius * (1 - half * half) / norm, y = radius * 2 * half / norm;
      t.sites[k] = k == 0 ? Site{x, y, 0} : k == 1 ? Site{-x, y, 0} : Site{y, -x, 0};
    }
    expectNearest(t);
    if (::testing::Test::HasFailure()) FAIL() << "run " << run;
  }
}

/// Next to the smallest numbers that there are, products of differences underflow; next to the
/// largest, they are as elsewhere.
TEST(PreciseCircle, IsTheSameAtEveryScale) {
  Random random(173);
  for (int run = 0; run < test::runs(300); ++run) {
    const auto number = [&] { return 0x1p52 + static_cast<double>(random.integer(0, 40)); };
    const Triangle t{
        {Site{number(), number(), 0}, {number(), number(), 0}, {number(), number(), 0}}};
    if (t.exact().twice.sign() != Sign::kPositive) continue;
    const VoronoiCircle one = t.circle();
    for (const int exponent : {-384, -300, -100, 100, 270}) {
      const double unit = powerOfTwo(exponent);
      Triangle scaled = t;
      for (Site& site : scaled.sites) site.x *= unit, site.y *= unit;
      const VoronoiCircle circle = scaled.circle();
      EXPECT_EQ(circle.x, unit * one.x) << exponent;
      EXPECT_EQ(circle.y, unit * one.y) << exponent;
      EXPECT_NEAR(circle.s / unit, one.s, 1e-13 * one.s) << exponent;
    }
    if (::testing::Test::HasFailure()) FAIL() << "run " << run;
  }
}

/// Numbers of all sizes are too long for an exact quotient, which is not tried then.
TEST(PreciseCircle, OfNumbersFromEndToEndOfTheRange) {
  for (const double tiny : {1e-100, 1e-60}) {
    for (const double large : {1e100, 1e60}) {
      const Site a{-large, 0, tiny}, b{0, -tiny, 0}, c{large, tiny, tiny / 3}, d{tiny, large, 1};
      for (const auto& [i, j, k] :
           {std::array<const Site*, 3>{&a, &b, &c}, {&a, &c, &d}, {&a, &b, &d}, {&b, &c, &d}}) {
        if (!hasVoronoiCircle(*i, *j, *k)) continue;
        const VoronoiCircle circle = commonVoronoiCircle(*i, *j, *k);
        const VoronoiCircle same = preciseVoronoiCircle(i, j, k);
        const double size = absolute(same.x) + absolute(same.y) + absolute(same.s);
        EXPECT_LE(absolute(circle.x - same.x), 1e-12 * size);
        EXPECT_LE(absolute(circle.s - same.s), 1e-12 * size);
      }
    }
  }
}

/// A coordinate is smaller than any of those given, and than one power of two can scale.
TEST(PreciseCircle, NextToAnAxisOfImmenseSitesIsOffItByNextToNothing) {
  Random random(176);
  for (int run = 0; run < 40; ++run) {
    const double large = run == 0 ? 5e99 : 1e100 * random.between(0.5, 1),
                 tiny = run == 0 ? 1e-100 : 1e-100 * random.between(1, 2);
    const Triangle t{{Site{large, 0, 0}, {tiny, large, 0}, {0, -large, 0}}};
    const Triangle::Exact exact = t.exact();
    for (const VoronoiCircle& circle :
         {t.circle(), preciseVoronoiCircle(&t.sites[0], &t.sites[1], &t.sites[2])}) {
      const Dyadic off = exact.y - Dyadic(circle.y) * exact.twice;
      EXPECT_EQ((magnitude(off) - magnitude(exact.y) * Dyadic(1e-14)).sign(), Sign::kNegative)
          << circle.y;
    }
  }
}

TEST(PreciseCircle, OfRandomNumbersOfAllSizes) {
  Random random(175);
  for (int run = 0; run < test::runs(3000); ++run) {
    const auto number = [&] {
      return std::ldexp(random.between(0.5, 1), static_cast<int>(random.integer(-330, 330))) *
             (random.oneIn(2) ? 1 : -1);
    };
    const Site i{number(), number(), 0}, j{number(), number(), 0}, k{number(), number(), 0};
    if (!hasVoronoiCircle(i, j, k)) continue;
    const VoronoiCircle circle = commonVoronoiCircle(i, j, k),
                        same = preciseVoronoiCircle(&i, &j, &k);
    const double size = absolute(same.x) + absolute(same.y) + absolute(same.s);
    if (!(size < 1e290)) continue;
    EXPECT_LE(absolute(circle.x - same.x), 1e-12 * size) << "run " << run;
    EXPECT_LE(absolute(circle.y - same.y), 1e-12 * size) << "run " << run;
  }
}

/// The cached circle too is as good at every scale: differences are brought to an ordinary size.
TEST(VoronoiCircle, HasTheSameBoundAtEveryScale) {
  const Site a{0, 0, 0.5}, b{3, 1, 0.25}, c{1, 4, 0};
  const VoronoiCircle one = voronoiCircle(&a, &b, &c);
  for (const int exponent : {-330, -100, -40, 40, 100, 330}) {
    const double unit = powerOfTwo(exponent);
    const auto scaled = [&](const Site& s) { return Site{s.x * unit, s.y * unit, s.r * unit}; };
    const Site i = scaled(a), j = scaled(b), k = scaled(c);
    const VoronoiCircle circle = voronoiCircle(&i, &j, &k);
    EXPECT_EQ(circle.x, one.x * unit) << exponent;
    EXPECT_EQ(circle.y, one.y * unit) << exponent;
    if (exponent > -90 && exponent <= 100) {  // the bound is a float
      EXPECT_NEAR(circle.error / unit, one.error, 0.01 * one.error) << exponent;
    }
  }
}

TEST(PreciseCircle, AtInfinityIsTheHalfPlane) {
  const Site i{0, 0, 1}, j{5, 0, 2};
  for (const std::array<Corner, 3>& corners :
       {std::array<Corner, 3>{&i, &j, nullptr}, {&i, nullptr, &j}, {nullptr, &i, &j}}) {
    const VoronoiCircle plane = voronoiCircle(corners[0], corners[1], corners[2]),
                        precise = preciseVoronoiCircle(corners[0], corners[1], corners[2]);
    EXPECT_TRUE(precise.isHalfPlane());
    EXPECT_TRUE(precise.x == plane.x && precise.y == plane.y && precise.s == plane.s);
  }
}

}  // namespace
}  // namespace apollonius::internal
