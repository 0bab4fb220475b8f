#include "geometry/polygons/cell_polygon.h"

#include <algorithm>

#include "geometry/window/polygon.h"
#include "number/fp.h"
#include "predicate/orientation.h"
#include "predicate/reference_site.h"

namespace apollonius::internal {

namespace {

/// Loops that exist by rounding only, where segments cross that should not, are thinner than this
/// share of their coordinates and of their distance from the site.
constexpr double kThinnest = powerOfTwo(-46);

Point centerOf(const Site& site) { return {site.x, site.y}; }

/// Is the area of a ring positive, or a hole's negative? Otherwise it has less than three different
/// points.
bool hasArea(std::span<const double> ring, bool isHole) {
  const auto at = [&](std::size_t k) { return Point{ring[2 * k], ring[2 * k + 1]}; };
  double area = 0;
  for (std::size_t k = 1; 2 * k + 2 < ring.size(); ++k)
    area += cross(at(k) - at(0), at(k + 1) - at(0));
  return isHole ? area < 0 : area > 0;
}

}  // namespace

PolygonFinder::PolygonFinder(const DiagramCore& core, CellClipper& cells, const Border& border,
                             Tolerance tolerance)
    : core_(core), cells_(cells), border_(border), chords_(border, tolerance) {}

void PolygonFinder::find(Slot site, Rings& rings) {
  const Soundness soundness = findRaw(site, rings);
  if (soundness == Soundness::kSure || rings.ringCount() == 0) return;
  if (soundness == Soundness::kUnsure) {
    // The rings are split where they cross, like those of a window.
    const NormalizedPolygon polygon = normalizePolygon(rings.coordinates, rings.starts);
    rings.clear();
    for (std::size_t k = 0; k < polygon.ringCount(); ++k) {
      for (const Point p : polygon.ring(k)) rings.add(p);
      rings.add(polygon.ring(k)[0]);
      rings.endRing();
    }
  }
  tracer_.clear();
  double size = 0;
  for (std::size_t k = 0; k < rings.ringCount(); ++k) {
    const std::span<const double> ring = rings.ring(k);
    tracer_.addRing(ring);
    for (std::size_t m = 0; m < ring.size(); m += 2) {
      const Point p{ring[m], ring[m + 1]};
      size = std::max({size, absolute(p.x), absolute(p.y), length(p - centerOf(site_))});
    }
  }
  if (soundness == Soundness::kUnsure || tracer_.hasTouch()) tracer_.trace(rings, kThinnest * size);
}

PolygonFinder::Soundness PolygonFinder::findRaw(Slot site, Rings& rings,
                                                FlatArray<char>* isBorder) {
  rings.clear();
  if (isBorder != nullptr) isBorder->clear();
  site_ = core_.site(site);
  soundness_ = Soundness::kSure;
  const Cell& cell = cells_.find(site);
  for (std::size_t part = 0; part < cell.partCount(); ++part) {
    for (std::uint32_t ring = cell.outers[part]; ring < cell.outers[part + 1]; ++ring) {
      const bool isHole = ring > cell.outers[part];
      if (appendRing(cell.ring(ring), isHole, rings, isBorder)) rings.endRing();
    }
    if (rings.ringCount() > rings.parts.back()) rings.endPart();
  }
  return soundness_;
}

bool PolygonFinder::appendRing(std::span<const BoundaryPiece> boundary, bool isHole, Rings& rings,
                               FlatArray<char>* isBorder) {
  const std::size_t begin = rings.coordinates.size();
  const auto atLeast = [&](Soundness found) { soundness_ = std::max(soundness_, found); };
  const Point center = centerOf(site_);
  Point last = boundary.front().curve.p0;
  append(last, rings, isBorder);
  const auto goTo = [&](Point p, bool isOnBorder) {
    if (p == last) return;
    if (isBorder != nullptr) isBorder->back() = static_cast<char>(isOnBorder);
    append(p, rings, isBorder);
    last = p;
  };
  const auto goAlong = [&](Point p, bool isOnBorder) {
    if (!(p == last) && orient2d(center, last, p) != Sign::kPositive) atLeast(Soundness::kUnsure);
    goTo(p, isOnBorder);
  };
  for (const BoundaryPiece& piece : boundary) {
    if (piece.isAtReach) {
      for (const Point p : chords_.find(atReach(piece, center))) goAlong(p, true);
      if (chords_.isAtBorder()) atLeast(Soundness::kUnsure);
      continue;
    }
    if (piece.neighbor == kNoSite) {
      atLeast(border_.isSimple(last, piece.curve.p2) ? Soundness::kTouches : Soundness::kUnsure);
      goTo(piece.curve.p2, true);
      continue;
    }
    const Site& other = core_.site(core_.ids().slotOf(piece.neighbor));
    // The chords are found in one direction, whichever of the two cells they are for.
    if (!precedes(site_, other)) {
      for (const Point p :
           chords_.find({piece.curve, center, centerOf(other), piece.fromSegment, piece.toSegment}))
        goAlong(p, false);
    } else {
      const std::span<const Point> chords = chords_.find(
          {piece.curve.reversed(), centerOf(other), center, piece.toSegment, piece.fromSegment});
      for (std::size_t k = chords.size(); k-- > 0;) goAlong(chords[k], false);
    }
    // The piece may touch the border between its ends, where the ring passes once more.
    if (chords_.isAtBorder()) atLeast(Soundness::kUnsure);
  }
  if (hasArea(std::span(rings.coordinates).subspan(begin), isHole)) return true;
  if (cells_.parts() == Parts::kThinToo && rings.coordinates.size() > begin + 4) {
    soundness_ = Soundness::kUnsure;
    return true;
  }
  if (isBorder != nullptr) isBorder->resize(begin / 2);
  rings.coordinates.resize(begin);
  return false;
}

/// A piece with nothing on its right: a part of the edge with a neighbor that does not reach so
/// far, whose cell's chords are inside of its circle; or an arc, for which any point beyond it
/// serves as the centre on the right.
EdgePiece PolygonFinder::atReach(const BoundaryPiece& piece, Point center) const {
  EdgePiece edge{piece.curve, center, {}, piece.fromSegment, piece.toSegment, 0};
  if (piece.neighbor == kNoSite) {
    edge.right = piece.curve.p1 + (piece.curve.p1 - center);
  } else {
    edge.right = centerOf(core_.site(core_.ids().slotOf(piece.neighbor)));
    edge.avoided = cells_.radiusOf(piece.neighbor);
  }
  return edge;
}

void PolygonFinder::append(Point p, Rings& rings, FlatArray<char>* isBorder) {
  rings.add(p + Point{});  // -0 becomes 0
  if (isBorder != nullptr) isBorder->push_back(0);
}

}  // namespace apollonius::internal
