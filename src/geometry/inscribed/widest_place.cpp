#include "geometry/inscribed/widest_place.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/infinite.h"
#include "number/fp.h"

namespace apollonius::internal {

namespace {

constexpr double kGap = powerOfTwo(-11);    // places better by less than this share are not sought
constexpr double kShare = powerOfTwo(-13);  // heights of pieces, of the r of a place
/// Random cells take some twenty steps, thin rings some hundred for each of their sides.
constexpr std::size_t kMostLooks = 1 << 16, kLooksOfCurve = 1 << 7;
constexpr std::size_t kManyPieces = 64;  // in a box, from which on no strips are looked for
constexpr double kParallel = 0.9;        // the cosine from which on two pieces are side by side
/// Pieces near a box are halved until there are this many.
constexpr std::size_t kManyNear = 64;
/// Up to this many, pieces are halved in their order, not the highest first.
constexpr std::size_t kFewNear = 16;
constexpr double kFine = 16;
constexpr int kMostMoves = 4;                    // to a place between three obstacles
constexpr double kLeastInner = powerOfTwo(-10);  // below which three of them are not around it
constexpr int kMostRounds = 16;
constexpr int kMostSteps = 32;  // in a linear program: nearly all take two to six

/// A vector of the linear program: of x, y and r.
struct Vector {
  double x, y, r;
};
Vector cross(const Vector& a, const Vector& b) {
  return {a.y * b.r - a.r * b.y, a.r * b.x - a.x * b.r, a.x * b.y - a.y * b.x};
}
double dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.r * b.r; }

/// Is a point outside of a box about the origin, or on its border?
bool isBeyond(Point p, Point half) { return absolute(p.x) >= half.x || absolute(p.y) >= half.y; }

template <class Function>
double mostAtCorners(Point half, const Function& at) {
  return std::max(std::max(at(Point{-half.x, -half.y}), at(Point{half.x, -half.y})),
                  std::max(at(Point{-half.x, half.y}), at(Point{half.x, half.y})));
}

/// The largest value of a linear function in a box about the origin.
double mostOf(Point slope, Point half) {
  return absolute(slope.x) * half.x + absolute(slope.y) * half.y;
}

}  // namespace

bool WidestPlace::isEnough(double most) const {
  // Bounds and places also have the error of the heights of pieces that are not halved.
  return !(most - best_.r > kGap * absolute(best_.r) + 2 * grain_);
}

bool WidestPlace::find(const Rectangle& box, double grain, Place& best,
                       const CellOfObstacle* cell) {
  grain_ = grain;
  best_ = best;
  cell_ = cell;
  boxes_.clear();
  near_.clear();
  near_.append(border_.rings());
  if (cell != nullptr) near_.push_back(kCircle);
  Box first{box.center(), {box.width() / 2, box.height() / 2}, 0, kInfinite, kInfinite, 0, 0, true,
            false};
  for (const std::uint32_t ring : border_.rings())
    first.above = std::min(first.above, length(first.center - border_.chord(ring).a));
  look(first, 0, static_cast<std::uint32_t>(near_.size()));
  const std::size_t most = kMostLooks + kLooksOfCurve * border_.curveCount();
  for (std::size_t looks = 1; !boxes_.empty() && !isEnough(boxes_[0].most); looks += 2) {
    if (looks > most) return false;
    std::pop_heap(boxes_.begin(), boxes_.end());
    const Box whole = boxes_.back();
    boxes_.pop_back();
    Box part = whole;
    const Point way = whole.isWide ? Point{whole.half.x / 2, 0} : Point{0, whole.half.y / 2};
    part.half = whole.half - way;
    part.above += length(way);
    for (const Point center : {whole.center - way, whole.center + way}) {
      part.center = center;
      look(part, whole.near, whole.end);
    }
  }
  best = best_;
  return true;
}

/// Examines a box and keeps it if a better place can be in it. The obstacles near it are among
/// near_[near] to before near_[end].
void WidestPlace::look(Box box, std::uint32_t near, std::uint32_t end) {
  box.reach = length(box.half);
  const bool wasFree = box.isFree;
  seen_.clear();
  if (cell_ != nullptr && !wasFree && !isInside(box)) return;
  gather(box, near, end);
  Mean mean;
  for (int round = 0;; ++round) {
    if (isEnough(box.above + box.reach)) return;
    meeting_.clear();
    if (!wasFree) listMeeting(box);
    if (cell_ == nullptr && !box.isFree && meeting_.empty()) {
      if (!border_.surrounds(box.center)) return;
      box.isFree = true;
    }
    listBounds(box);
    if (cell_ != nullptr && !box.isFree) listWalls(box);
    mean = leastMean(box.half);
    isSideBySide_ = false;
    if (!isEnough(mean.most)) boundByStrips(box, mean);
    box.most = std::min(mean.most, box.above + box.reach);
    if (isEnough(box.most)) return;
    consider(box.center + mean.at);
    box.most = std::min(box.most, boundAround(box, mean));
    if (isEnough(box.most)) return;
    if (round == kMostRounds) break;
    const bool isFiner = refineStrips(box);
    if (!refine(box, mean) && !isFiner) break;
  }
  if (box.above > best_.r) consider(box.center);
  if (isEnough(box.most)) return;
  const double acrossWidth = lossOf(mean, box, {box.half.x / 2, box.half.y}),
               acrossHeight = lossOf(mean, box, {box.half.x, box.half.y / 2});
  const bool isClear = absolute(acrossWidth - acrossHeight) > (box.most - best_.r) / 8;
  box.isWide = isClear ? acrossWidth < acrossHeight : box.half.x >= box.half.y;
  box.near = static_cast<std::uint32_t>(near_.size());
  for (const Near& one : seen_) near_.push_back(one.number);
  box.end = static_cast<std::uint32_t>(near_.size());
  boxes_.push_back(box);
  std::push_heap(boxes_.begin(), boxes_.end());
}

/// Fills seen_ with the obstacles that can be nearest somewhere in a box, or meet it.
void WidestPlace::gather(Box& box, std::uint32_t near, std::uint32_t end) {
  seen_.clear();
  for (std::uint32_t k = near; k < end; ++k) see(box, near_[k]);
  // Heights add to the bounds, whose error is otherwise about the square of the reach. The pieces
  // of the largest heights are halved first, and only some; where bounds need more, refine() does
  // it.
  const double fine = std::max(kShare * best_.r, box.reach / kFine);
  for (double most = seen_.size() < kFewNear ? fine : box.reach; most >= fine; most /= 2)
    halve(box, most);
  if (seen_.size() >= kManyNear) {
    const double distance = border_.distance(box.center, kShare, 0);
    box.above = std::min(box.above, distance * (1 + 2 * kShare) + grain_);
  }
}

/// Halves the pieces higher than `height`, unless there are many, and drops those that cannot be
/// nearest to any point of the box.
void WidestPlace::halve(Box& box, double height) {
  for (std::size_t k = 0; k < seen_.size();) {
    const auto [number, distance, own] = seen_[k];
    const double low = distance - own;
    if (low > box.above + 2 * box.reach) {
      seen_[k] = seen_.back();
      seen_.pop_back();
    } else if (own > height && (seen_.size() < kManyNear || own > box.reach) &&
               border_.firstHalf(number) != BorderTree::kWhole) {
      split(box, k);
    } else {
      ++k;
    }
  }
}

/// Replaces a piece by its halves.
void WidestPlace::split(Box& box, std::size_t k) {
  const std::uint32_t half = border_.firstHalf(seen_[k].number);
  see(box, half + 1);
  see(box, half);
  seen_[k] = seen_.back();
  seen_.pop_back();
}

void WidestPlace::see(Box& box, std::uint32_t number) {
  const Near one{number, distanceOf(number, box.center),
                 number != kCircle ? border_.height(number) : 0};
  box.above = std::min(box.above, one.distance + one.height);
  seen_.push_back(one);
}

/// Halves the pieces whose heights keep a mean above the best place; false if there are none, as
/// where a smaller box helps more.
bool WidestPlace::refine(Box& box, const Mean& mean) {
  const double fine = (box.most - best_.r) / 16;
  const std::size_t before = seen_.size();
  for (std::size_t k = 0; k < 3; ++k) {
    if (mean.weights[k] == 0) continue;
    if (bounds_[mean.bounds[k]].by == Bound::By::kWall) continue;
    const std::uint32_t number = bounds_[mean.bounds[k]].number;
    for (std::size_t n = 0; n < seen_.size(); ++n) {
      if (seen_[n].number != number) continue;
      if (mean.weights[k] * seen_[n].height > fine &&
          border_.firstHalf(number) != BorderTree::kWhole)
        split(box, n);
      break;
    }
  }
  return seen_.size() > before;
}

/// If the pieces of meeting_ run through the box side by side, halves those whose heights matter to
/// their strips; false if there are none.
bool WidestPlace::refineStrips(Box& box) {
  if (!isSideBySide_) return false;
  const double width =
      (meeting_.back().position - meeting_[0].position) / static_cast<double>(meeting_.size());
  const double fine = kShare * std::max(best_.r, width);
  const std::size_t before = seen_.size();
  for (const Meeting& one : meeting_) {
    if (!(one.height > fine)) continue;
    for (std::size_t n = 0; n < before; ++n) {
      if (seen_[n].number != one.piece) continue;
      if (border_.firstHalf(one.piece) != BorderTree::kWhole) split(box, n);
      break;
    }
  }
  return seen_.size() > before;
}

void WidestPlace::listMeeting(const Box& box) {
  for (const auto& [number, distance, height] : seen_) {
    if (number == kCircle || distance > box.reach + height) continue;
    const BorderChord chord = border_.chord(number),
                      whole{chord.a - box.center, chord.b - box.center};
    const Point half{box.half.x + height, box.half.y + height};
    BorderChord part = whole;
    if (!part.clip(half)) continue;
    const Point normal = leftOf(unit(chord.b - chord.a));
    const bool isThrough = isBeyond(whole.a, half) && isBeyond(whole.b, half);
    meeting_.push_back({number, height, part, normal, isThrough, 0});
  }
}

void WidestPlace::listBounds(const Box& box) {
  bounds_.clear();
  for (const auto& [number, distance, height] : seen_) {
    Point foot;
    if (number != kCircle) {
      const BorderChord chord = border_.chord(number);
      const double overhang = border_.overhang(number, std::max(2 * height, 4 * grain_));
      if (overhang < kInfinite) {
        const Point normal = leftOf(unit(chord.b - chord.a));
        const double value = dot(normal, box.center - chord.a);
        bounds_.push_back({Bound::By::kLine, number, value + overhang, 0, normal});
        continue;
      }
      foot = chord.nearestTo(box.center);
    } else {
      foot = cell_->own.center;
    }
    const Point way = box.center - foot;
    const double size = length(way);
    const Point slope = size > 0 ? (1 / size) * way : Point{};
    const double more = excess(Bound::By::kDistance, number, box.center, box.half, slope);
    bounds_.push_back({Bound::By::kDistance, number, distance + height + more, more, slope});
  }
}

/// Adds a bound for each line of the cell's outline that has the whole cell on one side.
void WidestPlace::listWalls(const Box& box) {
  BorderTree& outline = cell_->outline;
  outline.listMeeting(box.center, box.half, box.reach / kFine, outline_);
  for (const std::uint32_t piece : outline_) {
    const double overhang =
        outline.overhang(piece, std::max(2 * outline.height(piece), 4 * grain_));
    if (!(overhang < kInfinite)) continue;
    const BorderChord chord = outline.chord(piece);
    const Point normal = leftOf(unit(chord.b - chord.a));
    const double value = dot(normal, box.center - chord.a);
    bounds_.push_back({Bound::By::kWall, piece, value + overhang, 0, normal});
  }
}

/// Where all pieces in a box run through it side by side, the inside consists of strips between
/// them, and each strip is on one side of the lines of two pieces, or of one. Then replaces `mean`
/// by that of the strip with the most room, whose bounds are at the end of bounds_. Tries a place
/// in each strip.
void WidestPlace::boundByStrips(const Box& box, Mean& mean) {
  if (meeting_.empty() || meeting_.size() > kManyPieces) return;
  const Point across = meeting_[0].normal, along = leftOf(across);
  double low = -kInfinite, high = kInfinite;
  for (Meeting& one : meeting_) {
    if (!one.isThrough) return;
    const double cosine = dot(one.normal, across);
    if (!(absolute(cosine) > kParallel)) return;
    if (cosine < 0) one.normal = -1 * one.normal;
    const double from = dot(along, one.part.a), to = dot(along, one.part.b);
    low = std::max(low, std::min(from, to));
    high = std::min(high, std::max(from, to));
  }
  // A line that crosses all pieces meets them in the order of the strips. Without such a line, as
  // where two pieces cut off two corners of the box, they bound no strips.
  if (!(low < high)) return;
  for (Meeting& one : meeting_) {
    const Point way = one.part.b - one.part.a;
    const double share = ((low + high) / 2 - dot(along, one.part.a)) / dot(along, way);
    one.position = dot(across, one.part.a + share * way);
  }
  for (std::size_t k = 1; k < meeting_.size(); ++k)  // they are few
    for (std::size_t n = k; n > 0 && meeting_[n].position < meeting_[n - 1].position; --n)
      std::swap(meeting_[n], meeting_[n - 1]);
  isSideBySide_ = true;
  // Two curves may have another order than their parts where one part crosses the line of a later
  // one, or where their distance is less than their heights.
  const std::size_t count = meeting_.size();
  double height = 0, overlap = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const auto& [piece, own, part, normal, isThrough, position] = meeting_[k];
    height = std::max(height, own);
    for (std::size_t n = 0; n < count; ++n) {
      const double one = dot(normal, meeting_[n].part.a - part.a),
                   other = dot(normal, meeting_[n].part.b - part.a);
      overlap = std::max(overlap, n < k ? std::max(one, other) : -std::min(one, other));
    }
  }
  const double beyond = 2 * height + overlap;
  if (!(beyond < box.reach / 4)) return;
  const auto isCornerInside = [&](Point way) {
    return border_.surrounds(
        box.center + Point{std::copysign(box.half.x, way.x), std::copysign(box.half.y, way.y)});
  };
  bool isInside = isCornerInside(-1 * across);
  if (isCornerInside(across) != (isInside != (count % 2 == 1))) return;
  const std::size_t known = bounds_.size();
  const double above = mean.most;
  mean.most = -kInfinite;
  std::size_t widest = 0;
  const auto addStrip = [&](std::size_t k) {  // before meeting_[k]
    bounds_.setSize(known);
    for (const bool isBefore : {true, false}) {
      if (k == (isBefore ? 0 : count)) continue;
      const Meeting& one = meeting_[isBefore ? k - 1 : k];
      const Point normal = isBefore ? one.normal : -1 * one.normal;
      const double more = excess(Bound::By::kSide, one.piece, box.center, box.half, normal);
      const double value = -dot(normal, one.part.a) + 3 * beyond;
      bounds_.push_back({Bound::By::kSide, one.piece, value + more, more, normal});
    }
  };
  for (std::size_t k = 0; k <= count; ++k, isInside = !isInside) {
    if (!isInside) continue;
    addStrip(k);
    const Mean one = leastMean(box.half);
    if (one.most > best_.r) consider(box.center + one.at);
    if (!(one.most > mean.most)) continue;
    mean = one;
    widest = k;
  }
  mean.most = std::min(mean.most, above);
  addStrip(widest);
}

double WidestPlace::distanceOf(std::uint32_t number, Point p) const {
  if (number != kCircle) return length(p - border_.chord(number).nearestTo(p));
  return length(p - cell_->own.center) - cell_->own.r;
}

/// The most that a convex function is above its linear function at a corner of the box. Both have
/// the value and the slope at the centre in common.
double WidestPlace::excess(Bound::By by, std::uint32_t number, Point center, Point half,
                           Point slope) const {
  if (by == Bound::By::kLine || by == Bound::By::kWall) return 0;
  if (by == Bound::By::kSide) {  // the way from the foot on the line to the chord
    const BorderChord chord = border_.chord(number);
    const Point along{slope.y, -slope.x};
    const double before = dot(along, chord.a - center), behind = dot(along, chord.b - center);
    const double most = mostOf(along, half);
    return std::max(0.0, std::max(most + before, most - behind));
  }
  if (number != kCircle && !(slope == Point{})) {
    // Linear if all points of the box are on one side of the chord, with their feet on it.
    const BorderChord chord = border_.chord(number);
    const Point along{slope.y, -slope.x};
    const double most = mostOf(along, half), one = dot(along, chord.a - center),
                 other = dot(along, chord.b - center);
    if (std::min(one, other) <= -most && std::max(one, other) >= most &&
        dot(slope, center - chord.a) >= mostOf(slope, half))
      return 0;
  }
  const double distance = distanceOf(number, center);
  return std::max(0.0, mostAtCorners(half, [&](Point corner) {
                    return distanceOf(number, center + corner) - distance - dot(slope, corner);
                  }));
}

/// Solves the linear program by the dual simplex method: the optimum of three constraints at a time
/// is a bound, whether or not other constraints cut it off.
WidestPlace::Mean WidestPlace::leastMean(Point half) const {
  // Constraints: r - slope p <= value of each bound; then the sides x <= half.x, …
  const auto bounds = static_cast<std::uint32_t>(bounds_.size());
  const auto normalOf = [&](std::uint32_t k) -> Vector {
    if (k < bounds) {
      const double r = bounds_[k].by == Bound::By::kWall ? 0 : 1;
      return {-bounds_[k].slope.x, -bounds_[k].slope.y, r};
    }
    const double sign = (k - bounds) % 2 == 0 ? 1 : -1;
    return k - bounds < 2 ? Vector{sign, 0, 0} : Vector{0, sign, 0};
  };
  const auto valueOf = [&](std::uint32_t k) {
    return k < bounds ? bounds_[k].value : k - bounds < 2 ? half.x : half.y;
  };
  std::uint32_t first = 0;
  double least = kInfinite;
  for (std::uint32_t k = 0; k < bounds; ++k) {
    if (bounds_[k].by == Bound::By::kWall) continue;
    const double most = bounds_[k].value + mostOf(bounds_[k].slope, half);
    if (most < least) {
      least = most;
      first = k;
    }
  }
  const Point slope = bounds_[first].slope;
  std::array<std::uint32_t, 3> basis{first, bounds + (slope.x < 0 ? 1 : 0),
                                     bounds + (slope.y < 0 ? 3 : 2)};
  std::array<double, 3> weights{1, absolute(slope.x), absolute(slope.y)};
  Point at{std::copysign(half.x, slope.x), std::copysign(half.y, slope.y)};
  for (int step = 0; step < kMostSteps; ++step) {
    const std::array<Vector, 3> normals{normalOf(basis[0]), normalOf(basis[1]), normalOf(basis[2])};
    const std::array<Vector, 3> duals{cross(normals[1], normals[2]), cross(normals[2], normals[0]),
                                      cross(normals[0], normals[1])};
    const double determinant = dot(normals[0], duals[0]);
    if (determinant == 0) break;
    Vector optimum{0, 0, 0};
    for (std::size_t k = 0; k < 3; ++k) {
      const double share = valueOf(basis[k]) / determinant;
      optimum.x += share * duals[k].x;
      optimum.y += share * duals[k].y;
      optimum.r += share * duals[k].r;
    }
    at = {optimum.x, optimum.y};
    std::uint32_t entering = 0;
    double farthest = grain_;
    for (std::uint32_t k = 0; k < bounds + 4; ++k) {
      const double beyond = dot(normalOf(k), optimum) - valueOf(k);
      if (beyond > farthest) {
        farthest = beyond;
        entering = k;
      }
    }
    if (!(farthest > grain_)) break;
    const Vector normal = normalOf(entering);
    std::array<double, 3> shares;
    std::size_t leaving = 3;
    double ratio = kInfinite;
    for (std::size_t k = 0; k < 3; ++k) {
      shares[k] = dot(normal, duals[k]) / determinant;
      if (shares[k] > 0 && weights[k] / shares[k] < ratio) {
        ratio = weights[k] / shares[k];
        leaving = k;
      }
    }
    if (leaving == 3) break;
    for (std::size_t k = 0; k < 3; ++k) weights[k] = std::max(0.0, weights[k] - ratio * shares[k]);
    weights[leaving] = ratio;
    basis[leaving] = entering;
  }
  // Any weights give a bound, so rounding does not matter.
  Mean mean{{first, first, first}, {0, 0, 0}, least, at};
  mean.at = {std::clamp(at.x, -half.x, half.x), std::clamp(at.y, -half.y, half.y)};
  double sum = 0, value = 0;
  Point together{};
  for (std::size_t k = 0; k < 3; ++k) {
    if (basis[k] >= bounds) continue;
    const Bound& bound = bounds_[basis[k]];
    mean.bounds[k] = basis[k];
    mean.weights[k] = weights[k];
    if (bound.by != Bound::By::kWall) sum += weights[k];
    value += weights[k] * bound.value;
    together = together + weights[k] * bound.slope;
  }
  const double most = (value + mostOf(together, half)) / sum;
  if (!(most < least)) {
    mean.weights[0] = 1;
    mean.bounds[0] = first;
    mean.weights[1] = mean.weights[2] = 0;
    return mean;
  }
  for (double& weight : mean.weights) weight /= sum;
  mean.most = most;
  return mean;
}

/// A bound by three obstacles around a point p at the same distance v from them. With unit vectors
/// u towards p from their nearest points, at the distances d, none of which is less than `least`,
///
///     D(p + way) <= v + u way + way² / (2 least).
///
/// The triangle of the u has the origin inside, at the distance c from its sides. So one u has
/// u way <= - c |way|, and up to |way| = 2 c `least` no point is better. For lines, d is infinite.
/// Where c is 0, as between two obstacles, this is no bound. Tries the place at p.
double WidestPlace::boundAround(const Box& box, const Mean& mean) {
  if (std::min({mean.weights[0], mean.weights[1], mean.weights[2]}) == 0) return kInfinite;
  Point p = box.center + mean.at, slopes[3];
  double values[3], least = kInfinite, farthest = 0, inner = kInfinite;
  for (int step = 0; step < kMostMoves; ++step) {
    least = kInfinite;
    for (std::size_t k = 0; k < 3; ++k) {
      const Bound& bound = bounds_[mean.bounds[k]];
      if (bound.by == Bound::By::kSide || bound.by == Bound::By::kWall) return kInfinite;
      if (bound.by == Bound::By::kLine) {
        slopes[k] = bound.slope;
        values[k] = bound.value + dot(bound.slope, p - box.center);
        continue;
      }
      const bool isCircle = bound.number == kCircle;
      const Point foot = isCircle ? cell_->own.center : border_.chord(bound.number).nearestTo(p);
      const double away = length(p - foot);
      if (!(away > 0)) return kInfinite;
      slopes[k] = (1 / away) * (p - foot);
      values[k] = isCircle ? away - cell_->own.r : away + border_.height(bound.number);
      least = std::min(least, away);
    }
    const Point one = slopes[1] - slopes[0], other = slopes[2] - slopes[0];
    const double area = cross(one, other), first = values[0] - values[1],
                 second = values[0] - values[2];
    if (area == 0) return kInfinite;
    inner = kInfinite;
    for (std::size_t k = 0; k < 3; ++k) {
      const Point u = slopes[k], v = slopes[k < 2 ? k + 1 : 0];
      inner = std::min(inner, (area > 0 ? cross(u, v) : cross(v, u)) / length(v - u));
    }
    if (!(inner > kLeastInner)) return kInfinite;
    farthest = std::max({values[0], values[1], values[2]});
    // Moves to where the linear functions are equal. They nearly are, so the next values are equal
    // up to rounding.
    const Point way{(first * other.y - second * one.y) / area,
                    (second * one.x - first * other.x) / area};
    if (std::max(absolute(first), absolute(second)) <= kShare / 4 * farthest) break;
    p = p + way;
  }
  consider(p);
  const Point from = p - box.center;
  const double reach = length({absolute(from.x) + box.half.x, absolute(from.y) + box.half.y});
  return farthest + std::max(0.0, reach * (reach / (2 * least) - inner));
}

/// How far the largest value of a mean in a box of these extents may be above the r of places
/// there: the excess; and if a part of the box is outside, which may be where that value is, also
/// the growth of the mean from the centre on.
double WidestPlace::lossOf(const Mean& mean, const Box& box, Point half) const {
  double loss = 0;
  Point together{};
  for (std::size_t k = 0; k < 3; ++k) {
    if (mean.weights[k] == 0) continue;
    const Bound& bound = bounds_[mean.bounds[k]];
    loss += mean.weights[k] * excess(bound.by, bound.number, box.center, half, bound.slope);
    together = together + mean.weights[k] * bound.slope;
  }
  return box.isFree ? loss : loss + mostOf(together, half);
}

/// Is a part of the box in the cell? Tries a place on the outline, if one is in the box.
bool WidestPlace::isInside(Box& box) {
  Point place;
  if (cell_->outline.meets(box.center, box.half, place)) {
    consider(place, true);
    return true;
  }
  box.isFree = cell_->outline.surrounds(box.center);
  return box.isFree;
}

/// Replaces best_ by a place if that is inside and better.
void WidestPlace::consider(Point p, bool isInside) {
  for (const auto& [number, distance, height] : seen_)
    if (distanceOf(number, p) + height <= best_.r) return;
  double r = border_.distance(p, kShare, best_.r);
  if (cell_ != nullptr) r = std::min(r, distanceOf(kCircle, p));
  if (!(r > best_.r)) return;
  BorderTree& domain = cell_ != nullptr ? cell_->outline : border_;
  if (isInside || domain.surrounds(p)) best_ = {p, r};
}

}  // namespace apollonius::internal
