#include "predicate/circle_fan.h"

#include <algorithm>
#include <limits>

#include "predicate/circle_pair.h"

namespace apollonius {

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

// The arrays in numbers_, one after the other.
enum Array : std::size_t { kSiteX, kSiteY, kSiteR, kX, kY, kR, kP, kM, kL, kCircleX, kCircleY, kCircleS, kError, kArrays };

}  // namespace

void CircleFan::reserve(std::size_t n) {
  if (corners_.size() >= n) return;
  const std::size_t room = std::max(n, std::size_t{16}) * 3 / 2;
  const std::size_t stride = room + 2;  // the first two corners follow the last, for the last pair of faces
  numbers_.resize(kArrays * stride);
  stride_ = stride;
  corners_.resize(room);  // last: who looks at its size finds room in all
}

bool CircleFan::computeAll(const Site& q, std::size_t n) {
  double* const numbers = numbers_.data();
  double largest = 0;
  for (std::size_t k = 0; k < n; ++k) {
    // The site at infinity gets some finite row; its faces are computed below.
    const Site& site = corners_[k] != nullptr ? *corners_[k] : q;
    const double x = site.x - q.x, y = site.y - q.y, r = site.r - q.r;
    const double xx = x * x, yy = y * y, rr = r * r;
    const double l = std::max(std::max(absolute(x), absolute(y)), absolute(r));
    largest = std::max(largest, l);
    numbers[kSiteX * stride_ + k] = site.x;
    numbers[kSiteY * stride_ + k] = site.y;
    numbers[kSiteR * stride_ + k] = site.r;
    numbers[kX * stride_ + k] = x;
    numbers[kY * stride_ + k] = y;
    numbers[kR * stride_ + k] = r;
    numbers[kP * stride_ + k] = xx + yy - rr;
    numbers[kM * stride_ + k] = xx + yy + rr;
    numbers[kL * stride_ + k] = l;
  }
  for (std::size_t a = kSiteX; a <= kL; ++a) {
    for (std::size_t k = 0; k < 2; ++k) numbers[a * stride_ + n + k] = numbers[a * stride_ + k];
  }
  if (!(largest < kLargestDifference)) return false;
  computeBounded(q, n);
  return true;
}

void CircleFan::compute(const Site& q, std::span<VoronoiCircle> circles) {
  const std::size_t n = circles.size();
  const bool isOrdinary = computeAll(q, n);
  const double* const numbers = numbers_.data();
  for (std::size_t k = 0; k < n; ++k) {
    const Corner j = corners_[k], l = corners_[k + 1 < n ? k + 1 : 0];
    const double error = numbers[kError * stride_ + k];
    if (isOrdinary && j != nullptr && l != nullptr && error < kInfinite) {
      circles[k] = {numbers[kCircleX * stride_ + k], numbers[kCircleY * stride_ + k], numbers[kCircleS * stride_ + k], roundedUp(error), -1};
    } else {
      circles[k] = voronoiCircle(j, l, &q);
    }
  }
}

void CircleFan::computeBounded(const Site& q, std::size_t n) {
  const PairSite pole{pairOf(q.x), pairOf(q.y), pairOf(q.r)};
  const double* const in = numbers_.data();
  double* const out = numbers_.data();
  const auto load = [&](Array array, std::size_t k) { return loadPair(in + array * stride_ + k); };
  const auto row = [&](std::size_t k) { return PairRow{load(kX, k), load(kY, k), load(kR, k), load(kP, k), load(kM, k), load(kL, k)}; };
  for (std::size_t k = 0; k < n; k += 2) {
    const PairSite d{load(kSiteX, k + 1) - load(kSiteX, k), load(kSiteY, k + 1) - load(kSiteY, k), load(kSiteR, k + 1) - load(kSiteR, k)};
    const PairCircle circle = circlePair(pole, row(k), row(k + 1), d);
    storePair(out + kCircleX * stride_ + k, circle.x);
    storePair(out + kCircleY * stride_ + k, circle.y);
    storePair(out + kCircleS * stride_ + k, circle.s);
    storePair(out + kError * stride_ + k, circle.error);
  }
}

}  // namespace apollonius
