#include "support/close_calls.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>

#include "apollonius/diagram.h"
#include "predicate/compute_circle.h"

namespace apollonius::test {

using namespace internal;

namespace {

/// The legal number nearest to the result of a construction; 0 for NaN.
double legal(double value) {
  if (std::isnan(value)) return 0;
  const double magnitude = std::fabs(value);
  if (magnitude > kLargestMagnitude) return std::copysign(kLargestMagnitude, value);
  return magnitude < kSmallestMagnitude ? 0 : value;
}

class Maker {
 public:
  explicit Maker(const std::function<std::uint8_t()>& nextByte) : next_(nextByte) {}

  CloseCall make() {
    const std::uint8_t frame = next_();
    constexpr double kUnits[] = {1, 1, 1, 0.1, 0.01, 0x1p-20, 0x1p25, 1e97};
    unit_ = kUnits[frame & 7];
    // Far from the origin differences are rounded, near it they are exact.
    const double far = unit_ * std::ldexp(1.0, 8 * (frame >> 3 & 3));
    if ((frame & 0x20) != 0)
      origin_ = {far * small(), far * small(), (frame & 0x40) != 0 ? far * small() : 0};
    haveOneWeight_ = (frame & 0x80) != 0;
    for (; count_ < call_.sites.size(); ++count_) call_.sites[count_] = legalSite(site(next_()));
    setPoint();
    return call_;
  }

 private:
  double small() { return static_cast<std::int8_t>(next_()); }
  std::uint64_t next64() {
    std::uint64_t value = 0;
    for (int k = 0; k < 8; ++k) value = value << 8 | next_();
    return value;
  }
  /// All bits of a mantissa, magnitude of about 1.
  double narrow() {
    return std::bit_cast<double>((next64() & 0x800FFFFFFFFFFFFFu) | 0x3FE0000000000000u);
  }
  /// Any number of the range.
  double raw() {
    const std::uint8_t special = next_();
    if (special < 8)
      return special % 2 == 0 ? 0 : special % 4 == 1 ? kLargestMagnitude : kSmallestMagnitude;
    const double mantissa = narrow();
    return std::ldexp(mantissa, static_cast<int>((special | next_() << 8) % 662) - 330);
  }
  /// Mostly as it is, else a few doubles up or down.
  double nudged(double value) {
    const int steps = next_() % 16 - 8;
    for (int k = 0; k < 4 && k < -steps - 3; ++k)
      value = std::nextafter(value, -2 * kLargestMagnitude);
    for (int k = 0; k < 4 && k < steps - 3; ++k)
      value = std::nextafter(value, 2 * kLargestMagnitude);
    return value;
  }
  Site nudged(const Site& s) {
    const double x = nudged(s.x), y = nudged(s.y);
    return {x, y, nudged(s.r)};
  }
  /// A factor from far less than 1 to far more, or about 1.
  double share() {
    const std::uint8_t how = next_();
    const double about = static_cast<double>(next_()) / 64;
    return how < 128 ? about : std::ldexp(about, how % 64 - 32);
  }
  struct Direction {
    double x, y;
  };
  /// Exact with its length for half of them: Pythagorean triples.
  Direction direction(double& length) {
    const std::uint8_t how = next_();
    const double m = 1 + how % 8, n = how / 8 % 4;
    double x = m * m - n * n, y = 2 * m * n;
    length = m * m + n * n;
    if ((how & 0x20) != 0) std::swap(x, y);
    if ((how & 0x40) != 0) x = -x;
    if ((how & 0x80) != 0) y = -y;
    return {x, y};
  }

  const Site& former() { return call_.sites[next_() % count_]; }

  Site legalSite(Site s) {
    if (haveOneWeight_ && count_ > 0) s.r = call_.sites[0].r;
    return {legal(s.x), legal(s.y), legal(s.r)};
  }

  Site site(std::uint8_t kind) {
    // The kinds that look back at former sites and find enough of them.
    constexpr std::uint8_t kKinds[] = {4, 8, 10, 12, 12};
    switch (kind % kKinds[count_]) {
      case 1: {
        const double x = narrow(), y = narrow();
        return {origin_.x + unit_ * x, origin_.y + unit_ * y, origin_.r + unit_ * narrow()};
      }
      case 2: {
        const double x = raw(), y = raw();
        return {x, y, (next_() & 1) != 0 ? raw() : 0};
      }
      case 3:
        return aroundTheOrigin();
      case 4:
      case 5:
        return nudged(former());
      case 6:
      case 7:
        return touching(former());
      case 8:
      case 9:
        return onTheTangentLine();
      case 10:
        return touchingTheCircle();
      case 11:
        return shadowTowardsAVertex();
      default: {
        const double x = small(), y = small();
        return {origin_.x + unit_ * x, origin_.y + unit_ * y, origin_.r + unit_ * (next_() % 16)};
      }
    }
  }

  /// Touches the circle of radius 5 about the origin; exactly in integers.
  Site aroundTheOrigin() {
    double length = 1;
    const Direction d = direction(length);
    const double layers = next_() % 4 + 1;
    return nudged({origin_.x + unit_ * (layers * d.x), origin_.y + unit_ * (layers * d.y),
                   origin_.r + unit_ * (layers * length - 5)});
  }

  /// A site that touches another one from inside or from outside.
  Site touching(const Site& s) {
    double length = 1;
    const Direction d = direction(length);
    const double size = share();
    const double step = unit_ * size / ((next_() & 1) != 0 ? 1 : length);
    const double way = step * length;
    constexpr double kSigns[] = {-1, -1, 1};
    const std::uint8_t how = next_() % 3;
    return nudged(
        {s.x + step * d.x, s.y + step * d.y, how == 0 ? way - s.r : s.r + kSigns[how] * way});
  }

  /// Makes a site between two: centre and weight on the line through theirs, as linear functions.
  Site onTheTangentLine() {
    const Site &a = former(), &b = former();
    const double t = small() / 32;
    return nudged({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.r + t * (b.r - a.r)});
  }

  /// The Voronoi circle of three former sites. It need not exist: a site is made of its numbers
  /// anyway.
  VoronoiCircle circleOfFormer(Corner& reference) {
    const std::uint8_t which = next_();
    const std::size_t a = which % count_, b = (a + 1 + which / 8 % (count_ - 1)) % count_;
    std::size_t c = which / 64 % count_;
    while (c == a || c == b) c = (c + 1) % count_;
    reference = &call_.sites[a];
    return voronoiCircle(reference, &call_.sites[b],
                         (which & 0x80) != 0 ? nullptr : &call_.sites[c]);
  }

  Site touchingTheCircle() {
    Corner reference = nullptr;
    const VoronoiCircle circle = circleOfFormer(reference);
    double length = 1;
    const Direction d = direction(length);
    const double size = std::fabs(circle.s) + std::fabs(circle.s + reference->r);
    if (circle.isHalfPlane()) {
      // a x + b y + r = c
      const double x = reference->x + unit_ * small(), y = reference->y + unit_ * small();
      return nudged({x, y, circle.s - circle.x * x - circle.y * y});
    }
    const double way = share() * size / length;
    return nudged({circle.x + way * d.x, circle.y + way * d.y, way * length - circle.s});
  }

  /// q with q p_j - j p_q parallel to the direction of a vertex, or nearly: p_q is chosen, then q,
  /// then its weight.
  Site shadowTowardsAVertex() {
    Corner reference = nullptr;
    const VoronoiCircle circle = circleOfFormer(reference);
    const Site& j = former();
    const double jx = j.x - reference->x, jy = j.y - reference->y, jr = j.r - reference->r,
                 pj = jx * jx + jy * jy - jr * jr;
    const double dx = circle.isHalfPlane() ? circle.x : circle.x - reference->x;
    const double dy = circle.isHalfPlane() ? circle.y : circle.y - reference->y;
    const double size = share(), along = (next_() & 1) != 0 ? -size : size;
    const double scale = circle.isHalfPlane() ? std::sqrt(jx * jx + jy * jy) : 1;
    const double pq = share() * pj;
    const double x = jx * (pq / pj) + along * scale * dx, y = jy * (pq / pj) + along * scale * dy;
    const double square = x * x + y * y - pq;
    const double r = square > 0 ? std::sqrt(square) : 0;
    return nudged(
        {reference->x + x, reference->y + y, reference->r + ((next_() & 1) != 0 ? r : -r)});
  }

  void setPoint() {
    const std::uint8_t kind = next_();
    Corner reference = nullptr;
    double x = 0, y = 0;
    switch (kind % 6) {
      case 0:
        x = origin_.x + unit_ * small();
        y = origin_.y + unit_ * small();
        break;
      case 1:
        x = raw();
        y = raw();
        break;
      default: {  // a vertex, or on the way to it from a site, or across
        const VoronoiCircle circle = circleOfFormer(reference);
        const double t = kind % 6 < 4 ? 1 : share() - 1;
        const double dx = circle.isHalfPlane() ? unit_ * circle.x : circle.x - reference->x;
        const double dy = circle.isHalfPlane() ? unit_ * circle.y : circle.y - reference->y;
        const bool isAcross = kind % 6 == 5;
        x = nudged(reference->x + t * (isAcross ? -dy : dx));
        y = nudged(reference->y + t * (isAcross ? dx : dy));
      }
    }
    call_.x = legal(x);
    call_.y = legal(y);
  }

  const std::function<std::uint8_t()>& next_;
  CloseCall call_;
  std::size_t count_ = 0;
  double unit_ = 1;
  Site origin_;
  bool haveOneWeight_ = false;
};

}  // namespace

CloseCall closeCall(const std::function<std::uint8_t()>& nextByte) {
  return Maker(nextByte).make();
}

std::string toText(const CloseCall& call) {
  std::string text;
  char line[160];
  for (const Site& s : call.sites) {
    std::snprintf(line, sizeof line, "insert %a %a %a\n", s.x, s.y, s.r);
    text += line;
  }
  std::snprintf(line, sizeof line, "# point %a %a\n", call.x, call.y);
  return text + line;
}

}  // namespace apollonius::test
