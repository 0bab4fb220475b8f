#include "geometry/window/rectangle_clip.h"

#include <algorithm>

namespace apollonius::internal {

namespace {

struct SideCrossing {
  double e;
  int side;
  int step;  // +1: the edge goes beyond the side's line, -1: it comes back
};

/// The crossings of an edge with the lines of the four sides, in order; and of how many lines its
/// start is beyond.
class Crossings {
 public:
  Crossings(const Edge& edge, const Rectangle& window) {
    const auto form = [&](int side) {
      return LineForm(edge.bisector, Rectangle::normal(side), window.offset(side));
    };
    const std::array<LineForm, 4> forms{form(0), form(1), form(2), form(3)};
    const std::array<bool, 4> from = sidesBeyond(forms, edge.from, edge.e0, window),
                              to = sidesBeyond(forms, edge.to, edge.e1, window);
    for (std::size_t k = 0; k < 4; ++k) {
      const int side = static_cast<int>(k);
      beyondAtStart_ += from[k];
      double extremum = 0;
      if (from[k] != to[k]) {
        if (to[k]) {
          add({forms[k].rise(edge.e0, edge.e1), side, 1});
        } else {
          add({forms[k].fall(edge.e0, edge.e1), side, -1});
        }
      } else if (forms[k].hasExcursion(from[k] ? 1 : -1, edge.e0, edge.e1, extremum)) {
        if (from[k]) {
          add({forms[k].fall(edge.e0, extremum), side, -1});
          add({forms[k].rise(extremum, edge.e1), side, 1});
        } else {
          add({forms[k].rise(edge.e0, extremum), side, 1});
          add({forms[k].fall(extremum, edge.e1), side, -1});
        }
      }
    }
    separate(0, from[0], from[2]);
    separate(1, from[1], from[3]);
  }

  [[nodiscard]] int beyondAtStart() const { return beyondAtStart_; }
  [[nodiscard]] const SideCrossing* begin() const { return crossings_.data(); }
  [[nodiscard]] const SideCrossing* end() const { return crossings_.data() + count_; }

 private:
  /// Finds the sides whose lines an end is beyond. Its coordinates decide whether it is in the
  /// window at all, because its three edges must agree on that. If it is not, each edge decides by
  /// its own curve beyond which lines it is: the coordinates of a vertex far away can be off by
  /// more than the window's size.
  static std::array<bool, 4> sidesBeyond(const std::array<LineForm, 4>& forms, const EdgeEnd& end,
                                         double e, const Rectangle& window) {
    std::array<bool, 4> beyond{};
    if (end.isFinite && window.holds(end.point)) return beyond;
    bool any = false;
    for (std::size_t k = 0; k < 4; ++k) any = (beyond[k] = forms[k].isBeyond(e)) || any;
    for (std::size_t k = 0; k < 4 && !any; ++k)
      beyond[k] = window.isBeyond(static_cast<int>(k), end.point);
    return beyond;
  }

  /// Keeps them sorted; of equal ones the earlier added stays first, so that a line's own two do
  /// not change places.
  void add(SideCrossing c) {
    std::size_t k = count_++;
    for (; k > 0 && crossings_[k - 1].e > c.e; --k) crossings_[k] = crossings_[k - 1];
    crossings_[k] = c;
  }

  /// Nothing is beyond the lines of two opposite sides at once. Where the window is so thin that
  /// rounding has the edge go beyond the one before it comes back from the other, it comes back at
  /// that place, too.
  void separate(int side, bool isBeyond, bool isBeyondOpposite) {
    int beyond = isBeyond ? side : isBeyondOpposite ? side + 2 : -1;
    for (std::size_t k = 0; k < count_; ++k) {
      if (crossings_[k].side % 2 != side) continue;
      if (crossings_[k].step > 0 && beyond >= 0) {
        const double e = crossings_[k].e;
        std::size_t back = k + 1;
        while (back < count_ && !(crossings_[back].side == beyond && crossings_[back].step < 0))
          ++back;
        if (back == count_) return;
        std::rotate(crossings_.begin() + k, crossings_.begin() + back,
                    crossings_.begin() + back + 1);
        crossings_[k].e = e;
      }
      beyond = crossings_[k].step > 0 ? crossings_[k].side : -1;
    }
  }

  std::array<SideCrossing, 8> crossings_{};
  std::size_t count_ = 0;
  int beyondAtStart_ = 0;
};

/// A place on an edge: parameter, point, and the side it is on.
struct Mark {
  double e;
  Point point;
  signed char side;
};

ClippedPiece pieceBetween(const Bisector& bisector, const Mark& from, const Mark& to) {
  const Conic curve = pieceOf(bisector, from.e, to.e, from.point, to.point);
  const bool isCut = from.side != kNoSide || to.side != kNoSide;
  return {curve, from.side, to.side, isCut && isTouch(bisector, curve)};
}

/// Is the edge surely outside the window? Along an edge the distances from its sites, (D/2) cosh t
/// ± A, are largest at an end; so all of it is within weight + clearance of the reference site.
/// Enlarged by 2^-20, far more than rounding.
bool isFarAway(const Site& reference, const VoronoiCircle& a, const VoronoiCircle& b,
               const Rectangle& window) {
  if (a.isHalfPlane() || b.isHalfPlane() || !isPrecise(a) || !isPrecise(b)) return false;
  const double size = absolute(reference.r) + absolute(a.s) + absolute(b.s);
  const double reach = reference.r + std::max(a.s, b.s) + powerOfTwo(-20) * size;
  const double x = reference.x, y = reference.y;
  return x + reach < window.xmin || x - reach > window.xmax || y + reach < window.ymin ||
         y - reach > window.ymax;
}

}  // namespace

void clipEdge(const DelaunayGraph& delaunay, HalfedgeId h, const Rectangle& window,
              ClippedEdge& clipped, VertexPrecision precision, KeptVertices* kept) {
  clipped.count = 0;
  const Graph& g = delaunay.graph();
  if (isFarAway(delaunay.site(g.origin(h)), delaunay.circle(faceOf(g.twin(h))),
                delaunay.circle(faceOf(h)), window) ||
      (precision == VertexPrecision::kReproducible && delaunay.isPoint(h)))
    return;
  clipEdge(Edge(delaunay, h, precision, kept), window, clipped);
}

void clipEdge(const Edge& edge, const Rectangle& window, ClippedEdge& clipped) {
  clipped.count = 0;
  const Mark start{edge.e0, edge.from.point, kNoSide}, end{edge.e1, edge.to.point, kNoSide};
  if (edge.from.isFinite && edge.to.isFinite && window.holds(start.point) &&
      window.holds(end.point)) {
    // The usual case: the whole curve is within the triangle of its ends and p1.
    clipped.pieces[0] = pieceBetween(edge.bisector, start, end);
    if (window.holds(clipped.pieces[0].curve.p1)) {
      clipped.count = 1;
      return;
    }
  }
  const Crossings crossings(edge, window);
  int beyond = crossings.beyondAtStart();
  Mark from = start;
  for (const SideCrossing& crossing : crossings) {
    const bool wasInside = beyond == 0;
    beyond += crossing.step;
    if (!wasInside && beyond != 0) continue;
    const Point point = window.onSide(crossing.side, edge.bisector.at(crossing.e));
    const Mark mark{crossing.e, point, static_cast<signed char>(crossing.side)};
    if (wasInside)
      clipped.pieces[static_cast<std::size_t>(clipped.count++)] =
          pieceBetween(edge.bisector, from, mark);
    from = mark;
  }
  if (beyond == 0 && edge.to.isFinite)
    clipped.pieces[static_cast<std::size_t>(clipped.count++)] =
        pieceBetween(edge.bisector, from, end);
}

}  // namespace apollonius::internal
