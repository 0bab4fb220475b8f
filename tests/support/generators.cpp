#include "support/generators.h"

#include <array>
#include <cmath>

// Never two random numbers within one call's arguments: compilers evaluate arguments in different
// orders.
namespace apollonius::test {

namespace {

constexpr double kHalfSide = 1e6;  // randomCircles: centres in [-kHalfSide, kHalfSide]^2

/// sqrt(n) * R / side for a share of hidden circles. A circle of radius t*R is covered by about
/// kappa*(1-t)^3 others, kappa = pi*n*R^2 / (3*side^2); so the visible share is the integral of
/// exp(-kappa*u^3) over [0, 1], solved for kappa numerically.
double largestRadiusFactor(Hidden hidden) {
  switch (hidden) {
    case Hidden::kNone:
      return 0;
    case Hidden::k5Percent:
      return 0.4502;
    case Hidden::k20Percent:
      return 1.0023;
    case Hidden::k50Percent:
      return 2.3311;
    case Hidden::k95Percent:
      return 73.755;
  }
  return 0;
}

/// A Pythagorean triple with random signs: a^2 + b^2 = c^2, c > 0.
struct Triple {
  std::int64_t a;
  std::int64_t b;
  std::int64_t c;
};

Triple pythagorean(Random& random, int maxParameter, int maxScale) {
  const std::int64_t m = random.integer(1, maxParameter);
  const std::int64_t n = random.integer(0, m);
  const std::int64_t scale = random.integer(1, maxScale);
  Triple triple{scale * (m * m - n * n), scale * 2 * m * n, scale * (m * m + n * n)};
  if (random.oneIn(2)) std::swap(triple.a, triple.b);
  if (random.oneIn(2)) triple.a = -triple.a;
  if (random.oneIn(2)) triple.b = -triple.b;
  return triple;
}

Circle circleAt(std::int64_t x, std::int64_t y, std::int64_t r) {
  return {static_cast<double>(x), static_cast<double>(y), static_cast<double>(r)};
}

}  // namespace

Direction randomDirection(Random& random) {
  const double t = random.between(-1, 1);  // a quarter turn: directions within 90 degrees of +x
  const double inverse = 1 / (1 + t * t);
  const Direction quarter{(1 - t * t) * inverse, 2 * t * inverse};
  switch (random.below(4)) {
    case 0:
      return quarter;
    case 1:
      return {-quarter.y, quarter.x};
    case 2:
      return {-quarter.x, -quarter.y};
    default:
      return {quarter.y, -quarter.x};
  }
}

Circles randomCircles(Random& random, std::size_t n, Hidden hidden) {
  const double side = 2 * kHalfSide;
  const double largest =
      largestRadiusFactor(hidden) * side / std::sqrt(static_cast<double>(n) + (n == 0));
  Circles circles;
  for (std::size_t k = 0; k < n; ++k) {
    const double x = random.between(-kHalfSide, kHalfSide);
    const double y = random.between(-kHalfSide, kHalfSide);
    circles.push_back({x, y, largest * random.unit()});
  }
  return circles;
}

Circles outlier(Random& random, std::size_t n, double spacings) {
  Circles circles = randomCircles(random, n, Hidden::k5Percent);
  const double spacing = 2 * kHalfSide / std::sqrt(static_cast<double>(n) + (n == 0));
  if (n > 0) circles[random.below(n)] = {spacings * spacing, spacings * spacing, spacing};
  return circles;
}

Circles towns(Random& random, std::size_t n) {
  constexpr double kContinent = 8e7, kWidth = 100;
  std::array<Circle, 8> centres;
  for (Circle& centre : centres) {
    centre.x = random.between(0, kContinent);
    centre.y = random.between(0, kContinent);
  }
  const double spacing = kWidth / std::sqrt(static_cast<double>(n) / centres.size() + 1);
  Circles circles;
  for (std::size_t k = 0; k < n; ++k) {
    const Circle& centre = centres[random.below(centres.size())];
    const double x = centre.x + random.between(0, kWidth);
    const double y = centre.y + random.between(0, kWidth);
    circles.push_back({x, y, spacing * random.unit() / 2});
  }
  return circles;
}

Circles everyScale(Random& random, std::size_t n) {
  constexpr int kPowers = 40;
  // Between two powers there are n / 81 circles.
  const double spacing = std::sqrt((2 * kPowers + 1) / (static_cast<double>(n) + 1));
  Circles circles;
  for (std::size_t k = 0; k < n; ++k) {
    const int power = static_cast<int>(random.integer(-kPowers, kPowers));
    const double distance = std::ldexp(random.between(1, 2), power);
    const Direction direction = randomDirection(random);
    circles.push_back(
        {distance * direction.x, distance * direction.y, distance * spacing * random.unit()});
  }
  return circles;
}

Circles powerLaw(Random& random, std::size_t n) {
  // 10^(-6u) without libm: u in binary, the factor of bit k being 10^(-6 / 2^k), by repeated square
  // roots.
  Circles circles;
  for (std::size_t k = 0; k < n; ++k) {
    const double x = random.between(-kHalfSide, kHalfSide);
    const double y = random.between(-kHalfSide, kHalfSide);
    double factor = 1e-6;
    double r = 1e5;
    for (std::uint64_t bits = random.next(); bits != 0; bits <<= 1) {
      factor = std::sqrt(factor);
      if (bits >> 63) r *= factor;
    }
    circles.push_back({x, y, r});
  }
  return circles;
}

Circles giantDisk(Random& random, std::size_t n) {
  Circles circles{{0, 0, 1e6}};
  for (std::size_t k = 0; k < n; ++k) {
    const Direction direction = randomDirection(random);
    const double distance = 1e6 * random.between(0.9999, 1.001);
    circles.push_back({distance * direction.x, distance * direction.y, 1000 * random.unit()});
  }
  return circles;
}

Circles tinyGrid(Random& random, std::size_t n, int maxCoordinate, int maxRadius) {
  Circles circles;
  for (std::size_t k = 0; k < n; ++k) {
    const std::int64_t x = random.integer(0, maxCoordinate);
    const std::int64_t y = random.integer(0, maxCoordinate);
    circles.push_back(circleAt(x, y, random.integer(0, maxRadius)));
  }
  return circles;
}

Circles lattice(Random& random, int columns, int rows, double spacing, double r) {
  Circles circles;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column)
      circles.push_back({column * spacing, row * spacing, r});
  }
  random.shuffle(circles);
  return circles;
}

Circles equalRadii(Random& random, std::size_t n) {
  Circles circles;
  for (std::size_t k = 0; k < n; ++k) {
    const std::int64_t x = random.integer(-1000, 1000);
    circles.push_back(circleAt(x, random.integer(-1000, 1000), 7));
  }
  return circles;
}

Circles tangentOutside(Random& random, std::size_t n) {
  Circles circles;
  Circle last{0, 0, 5};
  for (std::size_t k = 0; k < n; ++k) {
    circles.push_back(last);
    const Triple step = pythagorean(random, 6, 4);
    // Tangent from outside: the radii add up to the distance; the chain may run over itself, which
    // is fine.
    const Circle& from = circles[random.below(circles.size())];
    last = {from.x + static_cast<double>(step.a), from.y + static_cast<double>(step.b),
            static_cast<double>(step.c) - from.r};
  }
  return circles;
}

Circles tangentInside(Random& random, std::size_t n) {
  Circles circles;
  Circle last{0, 0, 5};
  for (std::size_t k = 0; k < n; ++k) {
    circles.push_back(last);
    const Triple step = pythagorean(random, 4, 2);
    // Tangent from inside: the radii differ by the distance; inside or around the chosen circle.
    const Circle& from = circles[random.below(circles.size())];
    const double change = static_cast<double>(random.oneIn(2) ? step.c : -step.c);
    last = {from.x + static_cast<double>(step.a), from.y + static_cast<double>(step.b),
            from.r + change};
  }
  return circles;
}

Circles concentric(Random& random, std::size_t n) {
  const std::size_t centres = n / 4 + 1;
  Circles circles;
  for (std::size_t k = 0; k < n; ++k) {
    const std::int64_t r = random.integer(0, 8);
    if (k < centres) {
      const std::int64_t x = random.integer(0, 40);
      circles.push_back(circleAt(x, random.integer(0, 40), r));
    } else {
      const Circle& centre = circles[random.below(centres)];
      circles.push_back({centre.x, centre.y, static_cast<double>(r)});
    }
  }
  return circles;
}

Circles nestedFamilies(Random& random, std::size_t n) {
  const auto largest = static_cast<std::int64_t>(n) + 2;
  const std::int64_t families = 1 + static_cast<std::int64_t>(n) / 12;
  Circles circles;
  while (circles.size() < n) {
    const std::int64_t family = random.integer(0, families - 1), x = 3 * largest * family;
    const std::int64_t r = random.integer(1, largest);
    if (random.oneIn(12)) {
      circles.push_back(
          circleAt(x, 0, 3 * largest * random.integer(1, families) + random.integer(0, 3)));
      continue;
    }
    switch (family % 4) {
      case 0:
        circles.push_back(circleAt(x, 0, 5));
        break;
      case 1:
        circles.push_back(circleAt(x, 0, r));
        break;
      case 2:
        circles.push_back(circleAt(x + r, 0, r));
        break;
      default:
        circles.push_back(r % 2 == 0 ? circleAt(x, 0, 4 * (r / 4))
                                     : circleAt(x, 4 * (r / 4) + 2, 1));
        break;
    }
  }
  return circles;
}

Circles collinear(Random& random, std::size_t n, Line line, bool equalSpacing, int maxRadius) {
  std::int64_t stepX = 0;
  std::int64_t stepY = 0;
  switch (line) {
    case Line::kHorizontal:
      stepX = 3;
      break;
    case Line::kVertical:
      stepY = 3;
      break;
    case Line::kDiagonal:
      stepX = stepY = 2;
      break;
    case Line::kRandomSlope:
      stepX = random.integer(1, 9);
      stepY = random.integer(-9, 9);
      break;
  }
  const std::int64_t startX = random.integer(-20, 20);
  const std::int64_t startY = random.integer(-20, 20);
  const std::int64_t last = static_cast<std::int64_t>(n) * 3;
  Circles circles;
  for (std::size_t k = 0; k < n; ++k) {
    const std::int64_t position =
        equalSpacing ? static_cast<std::int64_t>(k) : random.integer(0, last);
    circles.push_back(circleAt(startX + position * stepX, startY + position * stepY,
                               random.integer(0, maxRadius)));
  }
  random.shuffle(circles);
  return circles;
}

Circles tangentLines(Random& random, std::size_t n, int lines, int heaviest) {
  // Along the line in steps of (a, b), away from it in steps of (-b, a): both are of length c.
  const Triple step = pythagorean(random, 3, 1);
  const std::int64_t width =
      heaviest + 1;  // between the lines: a weight of half of it touches both
  Circles circles;
  for (std::size_t k = 0; k < n; ++k) {
    const std::int64_t along = random.integer(0, static_cast<std::int64_t>(3 * n));
    const std::int64_t weight = random.integer(0, heaviest);
    const std::int64_t away = lines == 2 && random.oneIn(2) ? width - weight : weight;
    circles.push_back(
        circleAt(along * step.a - away * step.b, along * step.b + away * step.a, weight * step.c));
  }
  return circles;
}

Circles cocircularPoints(Random& random, std::size_t n) {
  constexpr std::int64_t kRadius = 32045;
  static const Circles all = [] {
    Circles points;
    for (std::int64_t x = -kRadius; x <= kRadius; ++x) {
      const std::int64_t square = kRadius * kRadius - x * x;
      const std::int64_t y = static_cast<std::int64_t>(std::sqrt(static_cast<double>(square)));
      if (y * y != square) continue;  // sqrt is exact for squares below 2^53
      points.push_back(circleAt(x, y, 1));
      if (y != 0) points.push_back(circleAt(x, -y, 1));
    }
    return points;
  }();
  Circles points = all;
  random.shuffle(points);
  if (n < points.size()) points.resize(n);
  return points;
}

Circles commonTangent(Random& random, std::size_t n, int common) {
  Circles circles;
  for (std::size_t k = 0; k < n; ++k) {
    const Triple triple = pythagorean(random, 7, 3);
    circles.push_back(circleAt(triple.a, triple.b, triple.c - common));
  }
  return circles;
}

Circles tangentInLayers(Random& random, std::size_t n) {
  Circles circles;
  const Circles directions = cocircularPoints(random, n);
  for (std::size_t k = 0; k < n; ++k) {
    const Circle& direction = directions[random.below(directions.size())];
    const auto layer =
        static_cast<double>(random.oneIn(2) ? 0 : random.integer(0, random.oneIn(8) ? 10000 : 6));
    Circle circle{direction.x * (layer + 1), direction.y * (layer + 1), 32045 * layer};
    if (random.oneIn(30)) circle.r += static_cast<double>(random.integer(-1, 1));
    circles.push_back(circle);
  }
  return circles;
}

Circles giantDiskExact(Random& random, std::size_t n) {
  constexpr std::int64_t kGiant = 32045;
  const Circles rim = cocircularPoints(random, n / 3);
  Circles circles{circleAt(0, 0, kGiant)};
  for (std::size_t k = 0; k < n; ++k) {
    if (k < rim.size()) {
      circles.push_back(rim[k]);
    } else {
      const Triple triple =
          pythagorean(random, 160, 2);  // c up to 51200, on both sides of the giant's rim
      const std::int64_t r = triple.c > kGiant ? triple.c - kGiant : kGiant - triple.c;
      circles.push_back(circleAt(triple.a, triple.b, r));
    }
  }
  random.shuffle(circles);
  return circles;
}

Circles rangeEnds(Random& random, std::size_t n, Range range) {
  const auto magnitude = [&]() -> double {
    if (random.oneIn(8)) return 0;
    double value = random.between(1, 2);
    switch (range) {
      case Range::kHuge:
        value = kLargestMagnitude * random.between(0.001, 1);
        break;
      case Range::kTiny:
        value = kSmallestMagnitude * random.between(1, 1000);
        break;
      // 2^-331 = 2.3e-100 and 2^331 = 4.4e99, times [1, 2).
      case Range::kMixed:
        value = std::ldexp(value, static_cast<int>(random.integer(-331, 331)));
        break;
    }
    return random.oneIn(2) ? value : -value;
  };
  Circles circles;
  for (std::size_t k = 0; k < n; ++k) {
    const double x = magnitude();
    const double y = magnitude();
    circles.push_back({x, y, range == Range::kMixed && random.oneIn(2) ? 0 : magnitude()});
  }
  return circles;
}

Circles nestedClusters(Random& random, std::size_t n, bool farApart) {
  Circles circles;
  const int exponents[] = {farApart ? -250 : 0, farApart ? 250 : 0};
  for (std::size_t k = 0; k < n; ++k) {
    const int exponent = exponents[k % 2];
    const double size = std::ldexp(1.0, exponent);
    if (k < 2) {
      const double x = size * random.between(1, 2);
      circles.push_back({x, -size * random.between(1, 2), size * random.unit()});
      continue;
    }
    const Circle& from = circles[k % 2 + 2 * random.below(k / 2)];  // one of the same family
    const auto offset = [&] {
      if (random.oneIn(3)) return 0.0;
      const double fraction = random.between(-1, 1);
      return std::ldexp(fraction, exponent - random.below(54));
    };
    const double x = from.x + offset();
    const double y = from.y + offset();
    circles.push_back({x, y, from.r + offset()});
  }
  return circles;
}

Circles oneUlpApart(Random& random, std::size_t n) {
  const auto step = [&](double value) {
    const std::int64_t count = random.integer(-3, 3);
    for (std::int64_t k = 0; k < count; ++k) value = std::nextafter(value, 2 * kLargestMagnitude);
    for (std::int64_t k = 0; k > count; --k) value = std::nextafter(value, -2 * kLargestMagnitude);
    return value;
  };
  const double scale =
      random.oneIn(2) ? 1 : 1e6;  // with scale 1, coordinates and radii have the same ulp
  const Circle base{scale * random.between(1, 2), -scale * random.between(1, 2),
                    random.oneIn(2) ? 0.1 : 1.5};
  Circles circles;
  for (std::size_t k = 0; k < n; ++k) {
    const double x = step(base.x);
    const double y = step(base.y);
    circles.push_back({x, y, random.oneIn(3) ? step(base.r) : base.r});
  }
  return circles;
}

}  // namespace apollonius::test
