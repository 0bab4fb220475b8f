#include "geometry/cell/cell_sums.h"

#include <limits>

namespace apollonius::internal {

CellSums::CellSums(const DiagramCore& core, const Rectangle& box, Measure what)
    : core_(core), box_(box), what_(what) {
  if (what == Measure::kCentroids) {
    moments_.resize(core.ids().slots());
  } else {
    sums_.resize(core.ids().slots());
  }
}

void CellSums::addEdge(Slot left, Slot right, const Conic& piece, int multiplicity) {
  if (what_ == Measure::kPerimeters) {
    const double length =
        multiplicity < 0 ? -multiplicity * lengthOf(piece) : multiplicity * lengthOf(piece);
    sums_[left].add(length);
    sums_[right].add(length);
    return;
  }
  const double beyond = what_ == Measure::kAreas ? areaBeyondChord(piece) : 0;
  addPiece(left, piece, beyond, multiplicity);
  addPiece(right, piece.reversed(), -beyond, multiplicity);
}

void CellSums::addBorder(Slot left, const Conic& piece) {
  if (what_ == Measure::kPerimeters) {
    sums_[left].add(lengthOf(piece));
  } else {
    addPiece(left, piece, what_ == Measure::kAreas ? areaBeyondChord(piece) : 0, 1);
  }
}

void CellSums::addPiece(Slot slot, const Conic& piece, double beyond, int multiplicity) {
  const Point origin = originOf(slot);
  if (what_ == Measure::kAreas) {
    const double term = cross(piece.p0 - origin, piece.p2 - origin) / 2 + beyond;
    sums_[slot].add(multiplicity * term);
    return;
  }
  Moments one;
  one.add(piece, origin);
  moments_[slot].area += multiplicity * one.area;
  moments_[slot].first = moments_[slot].first + static_cast<double>(multiplicity) * one.first;
}

void CellSums::list(std::vector<double>& measures) const {
  const IdPool& ids = core_.ids();
  if (what_ != Measure::kCentroids) {
    measures.assign(ids.idLimit(), 0);
    for (Slot slot = 0; slot < ids.slots(); ++slot) {
      if (const double sum = sumOf(slot); sum > 0) measures[ids.idOf(slot)] = sum;
    }
    return;
  }
  measures.assign(2 * ids.idLimit(), std::numeric_limits<double>::quiet_NaN());
  for (Slot slot = 0; slot < ids.slots(); ++slot) {
    const auto& [area, first] = moments_[slot];
    if (!(area > 0)) continue;
    const Point centroid = originOf(slot) + (1 / area) * first;
    double* const at = &measures[2 * std::size_t{ids.idOf(slot)}];
    at[0] = centroid.x;
    at[1] = centroid.y;
  }
}

}  // namespace apollonius::internal
