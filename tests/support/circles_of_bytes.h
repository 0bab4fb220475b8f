// Circles of a fuzzer's input: of a tiny grid, of narrow doubles, of raw bits, off decimal lattices
// by rounding, from close calls, and of the corpus.
#pragma once

#include "support/bytes.h"
#include "support/close_calls.h"
#include "support/corpus.h"

namespace apollonius::test {

/// Legal ones, at most forty.
inline Circles circlesOf(Bytes& bytes) {
  constexpr std::size_t kMostCircles = 40;
  Circles circles;
  const std::uint8_t mode = bytes.next();
  const std::size_t count = bytes.next() % kMostCircles;
  const auto small = [&] { return static_cast<double>(static_cast<std::int8_t>(bytes.next())); };
  switch (mode % 8) {
    case 0:
    case 1:
    case 2:
    case 3: {
      const auto numbers = static_cast<Numbers>(mode % 8);
      while (!bytes.empty() && circles.size() < count) {
        const double x = number(bytes, numbers), y = number(bytes, numbers);
        circles.push_back({x, y, (mode & 0x80) != 0 ? 0 : number(bytes, numbers)});
      }
      break;
    }
    case 4: {  // multiples of a decimal step, off by rounding, here or far away
      constexpr double kSteps[] = {0.1, 0.3, 8.53e-9, 48, 1e-3, 1.0 / 3, 0x1p-30, 1e90};
      const double step = kSteps[bytes.next() % 8];
      const double x0 = (mode & 0x40) != 0 ? 1000.1 * step : 0,
                   y0 = (mode & 0x40) != 0 ? -333.3 * step : 0;
      while (!bytes.empty() && circles.size() < count) {
        const double x = x0 + step * small(), y = y0 + step * small();
        circles.push_back({x, y, (mode & 0x80) != 0 ? 0 : step * (bytes.next() % 16)});
      }
      break;
    }
    case 5:
    case 6:
      while (!bytes.empty() && circles.size() < count) {
        for (const Site& s : closeCall([&] { return bytes.next(); }).sites)
          circles.push_back({s.x, s.y, s.r});
      }
      break;
    default: {
      const NamedGenerator& generator = corpus()[bytes.next() % corpus().size()];
      Random random(bytes.next());
      circles = generator.make(random, generator.large ? count + 1 : count % 9 + 1);
    }
  }
  std::erase_if(circles, [](const Circle& c) {
    return !(isInRange(c.x) && isInRange(c.y) && isInRange(c.r));
  });
  if (circles.size() > kMostCircles) circles.resize(kMostCircles);
  return circles;
}

}  // namespace apollonius::test
