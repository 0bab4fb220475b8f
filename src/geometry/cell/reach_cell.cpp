#include "geometry/cell/reach_cell.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/curve/arcs.h"

namespace apollonius::internal {

namespace {

/// Pseudo-angle from `start` to a direction, counter-clockwise: between 0 and 4, in the same order.
double turnFrom(Point start, Point direction) {
  const double c = dot(start, direction), s = cross(start, direction);
  return s >= 0 ? 1 - c : 3 + c;
}
/// The direction at such a turn from (1, 0).
Point directionAt(double turn) {
  if (turn < 0) turn += 4;
  const double c = turn <= 2 ? 1 - turn : turn - 3;
  const double s = std::sqrt(std::max((1 - c) * (1 + c), 0.0));
  return {c, turn <= 2 ? s : -s};
}

}  // namespace

const Cell& ReachCellClipper::find(Slot site) {
  const Cell& whole = cells_->find(site);
  if (whole.partCount() == 0) return whole;
  cell_.clear();
  site_ = core_.site(site);
  own_ = reachOf(site_, reach_.of(core_.ids().idOf(site)));
  if (!(own_.radius > 0)) return cell_;
  center_ = {site_.x, site_.y};
  rings_.clear(center_);
  pieces_.clear();
  exits_.clear();
  entries_.clear();
  for (std::size_t ring = 0; ring < whole.ringCount(); ++ring) cutRing(whole.ring(ring));
  if (!entries_.empty()) {
    sortPassages(whole);
  } else if (own_.radius < std::numeric_limits<double>::infinity() && isInside(whole, 0, 4)) {
    addArc({{1, 0}, kNoPiece}, {{1, 0}, kNoPiece}, 4);
    rings_.closeRing();
  }
  trace();
  rings_.sortInto(cell_);
  return cell_;
}

/// Finds the parts of a ring inside the circle, and where it leaves the circle and comes back.
void ReachCellClipper::cutRing(std::span<const BoundaryPiece> ring) {
  const auto begin = static_cast<std::uint32_t>(pieces_.size());
  for (std::uint32_t k = 0; k < ring.size(); ++k) {
    if (ring[k].neighbor == kNoSite) {
      cutBorder(ring[k], k);
    } else {
      cutEdge(ring[k], k);
    }
  }
  const auto end = static_cast<std::uint32_t>(pieces_.size());
  for (std::uint32_t k = begin; k < end; ++k) {
    const std::uint32_t next = k + 1 < end ? k + 1 : begin;
    Piece &a = pieces_[k], &b = pieces_[next];
    const bool isAdjacent =
        (a.source + 1) % ring.size() == b.source || (a.source == b.source && next > k);
    if (isAdjacent && !a.isToCut && !b.isFromCut) {
      a.next = next;
    } else {
      exits_.push_back({unit(a.piece.curve.p2 - center_), k});
      entries_.push_back({unit(b.piece.curve.p0 - center_), next});
    }
  }
}

void ReachCellClipper::cutEdge(const BoundaryPiece& piece, std::uint32_t source) {
  const Site& neighbor = core_.site(core_.ids().slotOf(piece.neighbor));
  const ReachedEdge edge =
      reachedEdge(site_, own_, neighbor, reachOf(neighbor, reach_.of(piece.neighbor)), piece.curve);
  for (std::size_t k = 0; k < edge.count; ++k) {
    const ReachedPiece& reached = edge.pieces[k];
    const bool isFirst = k == 0 && !reached.isFromCut;
    const bool isLast = k + 1 == edge.count && !reached.isToCut;
    pieces_.push_back({{reached.curve, piece.neighbor, isFirst ? piece.fromSegment : kNoSegment,
                        isLast ? piece.toSegment : kNoSegment, !reached.isShared, piece.isTouch},
                       reached.isFromCut,
                       reached.isToCut,
                       source});
  }
}

/// Cuts a straight piece of the window's border.
void ReachCellClipper::cutBorder(const BoundaryPiece& piece, std::uint32_t source) {
  const Point from = piece.curve.p0, way = piece.curve.p2 - from, toCenter = center_ - from;
  const double size = length(way);
  const Point direction = unit(way);
  const double aside = absolute(cross(direction, toCenter)), along = dot(direction, toCenter);
  if (!(aside < own_.radius)) return;
  const double half = own_.radius < std::numeric_limits<double>::infinity()
                          ? std::sqrt((own_.radius - aside) * (own_.radius + aside))
                          : own_.radius;
  const double first = along - half, last = along + half;
  if (!(first < size && last > 0)) return;
  const bool isFromCut = first > 0, isToCut = last < size;
  const Conic inside = Conic::segment(isFromCut ? from + first * direction : from,
                                      isToCut ? from + last * direction : piece.curve.p2);
  if (inside.p0 == inside.p2 && (isFromCut || isToCut)) return;  // as edges are cut
  pieces_.push_back(
      {{inside, kNoSite, piece.fromSegment, piece.toSegment}, isFromCut, isToCut, source});
}

/// Is an arc of the circle in the whole cell, if no boundary of the cell crosses it? The arc begins
/// at the turn `from`. It may touch the boundary, but hardly at two of the three points tested,
/// whose shares of the arc are in no simple proportion.
bool ReachCellClipper::isInside(const Cell& whole, double from, double width) const {
  int inside = 0;
  for (const double share : {0.29, 0.47, 0.64}) {
    const Point p = center_ + own_.radius * directionAt(from + share * width);
    bool isInside = false;
    for (const BoundaryPiece& piece : whole.pieces) isInside ^= crossesRay(piece.curve, p);
    inside += static_cast<int>(isInside);
  }
  return inside >= 2;
}

void ReachCellClipper::sortByTurn(Point start, FlatArray<Passage>& passages) {
  for (Passage& passage : passages) passage.turn = turnFrom(start, passage.direction);
  std::partial_sort(passages.begin(), passages.end(), passages.end(),
                    [](const Passage& a, const Passage& b) { return a.turn < b.turn; });
}

void ReachCellClipper::sortPassages(const Cell& whole) {
  FlatArray<Passage> all = exits_;
  all.append({entries_.data(), entries_.size()});
  sortByTurn({1, 0}, all);
  // Counting begins as far from all passages as possible: in the middle of the widest gap.
  double before = all.back().turn - 4, widest = 0, from = 0;
  for (const Passage& passage : all) {
    if (passage.turn - before > widest) {
      widest = passage.turn - before;
      from = before;
    }
    before = passage.turn;
  }
  const Point start = directionAt(from + widest / 2);
  sortByTurn(start, exits_);
  sortByTurn(start, entries_);
  shift_ = isInside(whole, from, widest) ? 1 : 0;
  exitOf_.assign(pieces_.size(), kNoPiece);
  for (std::uint32_t k = 0; k < exits_.size(); ++k) exitOf_[exits_[k].piece] = k;
}

/// Traces the rings: along the pieces, and along the circle from exits to entries.
void ReachCellClipper::trace() {
  isUsed_.assign(pieces_.size(), 0);
  for (std::uint32_t first = 0; first < pieces_.size(); ++first) {
    if (isUsed_[first] != 0) continue;
    for (std::uint32_t k = first; isUsed_[k] == 0;) {
      isUsed_[k] = 1;
      rings_.add(pieces_[k].piece);
      if (pieces_[k].next != kNoPiece) {
        k = pieces_[k].next;
        continue;
      }
      const Passage& exit = exits_[exitOf_[k]];
      const std::uint32_t number = exitOf_[k] + shift_;
      const bool isPastStart = number == entries_.size();
      const Passage& entry = entries_[isPastStart ? 0 : number];
      addArc(exit, entry, entry.turn - exit.turn + (isPastStart ? 4 : 0));
      k = entry.piece;
    }
    rings_.closeRing();
  }
}

/// Adds the arc from an exit to an entry, or a segment where the entry comes first by rounding.
void ReachCellClipper::addArc(const Passage& exit, const Passage& entry, double turn) {
  const auto pieceOf = [&](std::uint32_t k) { return k == kNoPiece ? nullptr : &pieces_[k].piece; };
  const BoundaryPiece *const before = pieceOf(exit.piece), *const after = pieceOf(entry.piece);
  FlatArray<Conic> arcs;
  if (turn > 0) {
    const bool isShort = turn < 2 && isQuarterAtMost(exit.direction, entry.direction);
    visitQuarters(exit.direction, entry.direction, isShort, [&](Point a, Point b) {
      arcs.push_back(Conic::arc(center_, own_.radius, a, b));
    });
    if (before != nullptr) arcs[0].p0 = before->curve.p2;
    if (after != nullptr) arcs.back().p2 = after->curve.p0;
  } else if (!(before->curve.p2 == after->curve.p0)) {
    arcs.push_back(Conic::segment(before->curve.p2, after->curve.p0));
  }
  for (std::size_t k = 0; k < arcs.size(); ++k) {
    const bool isFirst = k == 0 && before != nullptr,
               isLast = k + 1 == arcs.size() && after != nullptr;
    rings_.add({arcs[k], kNoSite, isFirst ? before->toSegment : kNoSegment,
                isLast ? after->fromSegment : kNoSegment, true});
  }
}

}  // namespace apollonius::internal
