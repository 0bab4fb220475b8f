#include "geometry/inscribed/border_tree.h"

#include <algorithm>
#include <utility>

#include "base/infinite.h"
#include "number/fp.h"

namespace apollonius::internal {

namespace {

/// Rounding may add this share to a height.
constexpr double kRounded = 1 + powerOfTwo(-40);

double distanceTo(const BorderChord& chord, Point p) { return length(p - chord.nearestTo(p)); }

/// Is p beyond the box of a chord, widened by a height, above it, below it, or to the right?
bool isRayBeside(const BorderChord& chord, double height, Point p) {
  const auto& [a, b] = chord;
  return std::max(a.y, b.y) + height < p.y || std::min(a.y, b.y) - height > p.y ||
         std::max(a.x, b.x) + height < p.x;
}

/// Does the ray from p to the right cross the chord?
bool isRayCrossing(const BorderChord& chord, Point p) {
  const auto& [a, b] = chord;
  return (a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * ((p.y - a.y) / (b.y - a.y));
}

}  // namespace

bool BorderChord::clip(Point half) {
  const Point from = a, way = b - a;
  double begin = 0, end = 1;
  const auto cut = [&](double at, double step, double most) {
    if (step == 0) return absolute(at) <= most;
    const double one = (-most - at) / step, other = (most - at) / step;
    begin = std::max(begin, std::min(one, other));
    end = std::min(end, std::max(one, other));
    return begin <= end;
  };
  if (!cut(from.x, way.x, half.x) || !cut(from.y, way.y, half.y)) return false;
  *this = {from + begin * way, from + end * way};
  return true;
}

void BorderTree::push(const Conic& curve, std::uint32_t curves) {
  Piece piece{curve};
  piece.height = kRounded * curve.sagitta();
  piece.curves = curves;
  pieces_.push_back(piece);
}

void BorderTree::addRing(std::span<const Conic> ring) {
  // Level by level: the pieces that have been made are the queue of those to be halved.
  const auto chordOf = [&](std::size_t first, std::size_t count) {
    return count == 1 ? ring[first] : Conic::segment(ring[first].p0, ring[first + count - 1].p2);
  };
  curves_ += ring.size();
  const auto root = static_cast<std::uint32_t>(pieces_.size());
  rings_.push_back(root);
  push(chordOf(0, ring.size()), static_cast<std::uint32_t>(ring.size()));
  pieces_[root].half = 0;
  for (std::size_t k = root; k < pieces_.size(); ++k) {
    const std::uint32_t first = pieces_[k].half, count = pieces_[k].curves;
    pieces_[k].half = kWhole;
    if (count == 1) continue;
    const BorderChord chord{pieces_[k].curve.p0, pieces_[k].curve.p2};
    double height = 0, fromStart = 0;
    for (const Conic& curve : ring.subspan(first, count)) {
      const double fromEnd = distanceTo(chord, curve.p2);
      height = std::max(height, std::max(fromStart, fromEnd) + curve.sagitta());
      fromStart = fromEnd;
    }
    pieces_[k].height = kRounded * height;
    const auto half = static_cast<std::uint32_t>(pieces_.size());
    const std::uint32_t left = count / 2;
    push(chordOf(first, left), left);
    pieces_.back().half = first;
    push(chordOf(first + left, count - left), count - left);
    pieces_.back().half = first + left;
    pieces_[k].half = half;
  }
}

std::uint32_t BorderTree::firstHalf(std::uint32_t piece) {
  const Piece& whole = pieces_[piece];
  if (whole.half != kWhole || !(whole.height > finest_)) return whole.half;
  Conic first, second;
  whole.curve.halve(first, second);
  if (!whole.curve.isSplitBy(first.p2)) return kWhole;
  const auto half = static_cast<std::uint32_t>(pieces_.size());
  pieces_[piece].half = half;
  push(first, 0);
  push(second, 0);
  return half;
}

double BorderTree::distance(Point p, double share, double enough) {
  const auto seen = [&](std::uint32_t piece) {
    todo_.push_back({piece, distanceTo(chord(piece), p)});
  };
  double least = kInfinite;
  todo_.clear();
  for (const std::uint32_t ring : rings_) seen(ring);
  while (!todo_.empty()) {
    const Seen one = todo_.back();
    todo_.pop_back();
    const double height = pieces_[one.piece].height, low = one.distance - height;
    if (low >= least) continue;
    if (one.distance + height <= enough) return one.distance + height;
    const std::uint32_t half = height > share * low ? firstHalf(one.piece) : kWhole;
    if (half == kWhole) {
      least = low;
      continue;
    }
    seen(half);
    seen(half + 1);
    Seen &last = todo_.back(), &other = todo_[todo_.size() - 2];
    if (other.distance < last.distance) std::swap(last, other);  // the nearer one first
  }
  return least;
}

bool BorderTree::meets(Point center, Point half, Point& place) {
  todo_.clear();
  for (const std::uint32_t ring : rings_) todo_.push_back({ring, 0});
  while (!todo_.empty()) {
    const std::uint32_t piece = todo_.back().piece;
    todo_.pop_back();
    const auto [a, b] = chord(piece);
    const double height = pieces_[piece].height;
    BorderChord part{a - center, b - center};
    if (!part.clip({half.x + height, half.y + height})) continue;
    const std::uint32_t first = firstHalf(piece);
    if (first == kWhole) {
      place = center + middle(part.a, part.b);
      return true;
    }
    todo_.push_back({first + 1, 0});
    todo_.push_back({first, 0});
  }
  return false;
}

void BorderTree::listMeeting(Point center, Point half, double fine,
                             FlatArray<std::uint32_t>& pieces) {
  pieces.assign(rings_);
  std::size_t kept = 0;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const std::uint32_t piece = pieces[k];
    const auto [a, b] = chord(piece);
    const double height = pieces_[piece].height;
    BorderChord part{a - center, b - center};
    if (!part.clip({half.x + height, half.y + height})) continue;
    const std::uint32_t first = height > fine ? firstHalf(piece) : kWhole;
    if (first == kWhole) {
      pieces[kept++] = piece;
    } else {
      pieces.push_back(first);
      pieces.push_back(first + 1);
    }
  }
  pieces.setSize(kept);
}

// The curve of a piece and its chord, backwards, are a closed curve within the height of the chord.
// It does not go around a place that is farther from the chord. So a ray from there crosses the two
// equally often, up to an even number.
bool BorderTree::surrounds(Point p) {
  bool isInside = false;
  todo_.clear();
  for (const std::uint32_t ring : rings_) todo_.push_back({ring, 0});
  while (!todo_.empty()) {
    const std::uint32_t piece = todo_.back().piece;
    todo_.pop_back();
    const BorderChord line = chord(piece);
    const double height = pieces_[piece].height;
    if (isRayBeside(line, height, p)) continue;
    const std::uint32_t half =
        height > 0 && distanceTo(line, p) <= height ? firstHalf(piece) : kWhole;
    if (half == kWhole) {
      if (isRayCrossing(line, p)) isInside = !isInside;
    } else {
      todo_.push_back({half, 0});
      todo_.push_back({half + 1, 0});
    }
  }
  return isInside;
}

double BorderTree::overhang(std::uint32_t piece, double most) {
  const double known = pieces_[piece].overhang;
  if (known == kUnknown || (known > most && known < kInfinite)) {
    // Heights of others matter as much as that of the piece itself.
    const double fine = std::max(2 * pieces_[piece].height, finest_ / 8);
    const double found = overhangOf(chord(piece), fine, most);
    pieces_[piece].overhang = found;  // not before: pieces may have been added
  }
  return pieces_[piece].overhang;
}

/// Pieces are halved down to heights of about `fine`.
double BorderTree::overhangOf(const BorderChord& line, double fine, double most) {
  const Point way = line.b - line.a;
  const double size = length(way);
  if (!(size > 0)) return kInfinite;
  const Point normal{-way.y / size, way.x / size};
  double found = 0;
  todo_.clear();
  for (const std::uint32_t ring : rings_) todo_.push_back({ring, 0});
  while (!todo_.empty()) {
    const std::uint32_t piece = todo_.back().piece;
    todo_.pop_back();
    const auto [a, b] = chord(piece);
    const double beyond = -std::min(dot(normal, a - line.a), dot(normal, b - line.a));
    const double atMost = beyond + pieces_[piece].height;
    if (atMost <= found) continue;
    if (beyond > most) return kInfinite;
    const std::uint32_t half = atMost > fine ? firstHalf(piece) : kWhole;
    if (half != kWhole) {
      todo_.push_back({half, 0});
      todo_.push_back({half + 1, 0});
    } else if (atMost > most) {
      return kInfinite;
    } else {
      found = atMost;
    }
  }
  return found;
}

}  // namespace apollonius::internal
