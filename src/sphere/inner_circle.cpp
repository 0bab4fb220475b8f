// Branch and bound over the faces of a cube about the sphere, which are divided into four
// repeatedly. The distance from the border, negative outside of the cell, changes by no more than
// the point moves. So the distance in the middle of a square and the distance of its corners bound
// it in the square.
//
// In a thin cell, this would need squares as small as the cell is thin. But let two arcs of the
// border have the square between them, with unit normals m and n into the cell, each so long that
// the foot of every point of the square is on it. For a point p at the angles d and e from them,
// sin min(d, e) <= (sin d + sin e) / 2 = (m + n) p / 2, which changes only by |m + n| / 2 times the
// way: by little, if the arcs run side by side. (A point beyond one of the arcs is no farther from
// it than the square reaches beyond.) The middle between them is a candidate, too.
//
// The border is that of the polygon within a slack of the cell (polygons.h), small against the
// circle; the slack is subtracted at the end.
//
// A point is in the cell unless a neighbour is nearer. Proof. Let a point not be in the cell. On
// the shortest way to it from the site's centre, let x be the point where the way leaves the cell,
// and n the neighbour on the other side. From x on, the distance from the site grows by the length
// of the way, and that from n by no more: n is at least as near as the site.
#include "sphere/inner_circle.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

#include "base/flat_array.h"
#include "sphere/polygons.h"

namespace apollonius::internal::sphere {

namespace {

constexpr double kGap = 0x1p-11;    // circles larger by less than this share are not sought
constexpr double kSlack = 0x1p-13;  // as a share of the circle's radius
constexpr double kCoarse = 1e-3, kFinest = 1e-15;  // slacks in radians
constexpr double kSmallest = 0x1p-50;              // half the side of a square
constexpr int kMostLooks = 1 << 20;

/// An arc of the border, the cell on its left.
struct Arc {
  Direction a, b;
  Direction normal;        // unit vector at right angles to its great circle
  Direction fromA, fromB;  // along the great circle, into the arc
};

/// A square of a face of the cube.
struct Square {
  double bound;  // upper bound of the distance from the border in it
  double u, v, half;
  std::uint8_t face;

  friend bool operator<(const Square& a, const Square& b) { return a.bound < b.bound; }
};

/// The point of a face at (u, v) in [-1, 1] x [-1, 1]. On the sphere, points are no farther apart
/// than on the face.
Direction pointOn(std::uint8_t face, double u, double v) {
  const double side = face % 2 == 0 ? 1 : -1;
  return normalized(face < 2   ? Direction{side, u, v}
                    : face < 4 ? Direction{u, side, v}
                               : Direction{u, v, side});
}

class Search {
 public:
  Search(const ProjectedDiagram& diagram, VertexId node, const AngularReach& reach)
      : diagram_(diagram), node_(node), reach_(reach), most_(reach.of(diagram, node)) {
    const Graph& graph = diagram.graph();
    if (!graph.isEmpty()) {
      for (const HalfedgeId h : graph.star(node))
        neighbors_.push_back(diagram.cap(graph.target(h)));
    } else if (diagram.visibleCount() == 2) {
      neighbors_.push_back(diagram.cap(otherOfTwo(diagram, node)));
    }
  }

  bool run(InnerCircle& circle) {
    circle = {diagram_.cap(node_).centre, 0};
    for (double slack = kCoarse;;) {
      drawBorder(slack);
      if (arcs_.empty()) {
        // The whole sphere, or a cell without width
        if (neighbors_.empty() && most_ >= std::numbers::pi) circle.radius = std::numbers::pi;
        return true;
      }
      if (!widen(circle)) return false;
      if (slack <= kSlack * circle.radius || slack <= kFinest) {
        circle.radius = std::max(0.0, circle.radius - slack);
        return true;
      }
      slack = std::max(kFinest, std::min(slack / 16, kSlack / 2 * circle.radius));
    }
  }

 private:
  void drawBorder(double slack) {
    CellPolygons cells(diagram_, slack, false, reach_, SphericalVertices::Of::kSome);
    cells.append(node_);
    const LonLatRings& rings = cells.rings();
    arcs_.clear();
    for (std::size_t ring = 0; ring + 1 < rings.starts.size(); ++ring) {
      for (std::size_t k = rings.starts[ring]; k + 1 < rings.starts[ring + 1]; ++k) {
        const double* at = &rings.coordinates[2 * k];
        const Direction a = directionOf({at[0], at[1]}), b = directionOf({at[2], at[3]});
        const Direction across =
            cross(a, b - a);  // for a short arc, (b - a) is more accurate than b
        if (!(lengthOf(across) > 0)) continue;
        const Direction normal = normalized(across);
        arcs_.push_back({a, b, normal, cross(normal, a), cross(b, normal)});
      }
    }
  }

  /// Finds the largest circle; keeps the one given unless that is smaller by more than the gap.
  bool widen(InnerCircle& circle) {
    best_ = circle;
    best_.radius = distanceAt(circle.centre);
    squares_.clear();
    int looks = 0;
    for (std::uint8_t face = 0; face < 6; ++face) consider({0, 0, 0, 1, face});
    while (!squares_.empty() && squares_[0].bound > least()) {
      std::pop_heap(squares_.begin(), squares_.end());
      const Square square = squares_.back();
      squares_.pop_back();
      if ((looks += 4) > kMostLooks) return false;
      const double half = square.half / 2;
      for (const double u : {square.u - half, square.u + half})
        for (const double v : {square.v - half, square.v + half})
          consider({0, u, v, half, square.face});
    }
    circle = best_;
    return true;
  }

  [[nodiscard]] double least() const { return best_.radius * (1 + kGap); }

  void consider(Square square) {
    const Direction place = pointOn(square.face, square.u, square.v);
    const double reach = std::numbers::sqrt2 * square.half, distance = lookAt(place);
    square.bound = distance + reach;
    if (!(square.bound > least()) || square.half < kSmallest) return;
    if (distance > 0 && nearest_ != nullptr)
      square.bound = std::min(square.bound, boundBetween(*nearest_, place, distance, reach));
    if (!(square.bound > least())) return;
    squares_.push_back(square);
    std::push_heap(squares_.begin(), squares_.end());
  }

  /// Returns the distance of a candidate, and keeps it if it is the best.
  double lookAt(const Direction& place) {
    const double distance = distanceAt(place);
    if (distance > best_.radius) best_ = {place, distance};
    return distance;
  }

  /// Do all points within the distance `reach` of `place` have their feet on the arc?
  static bool hasFeet(const Arc& arc, const Direction& place, double reach) {
    return dot(arc.fromA, place - arc.a) > reach && dot(arc.fromB, place - arc.b) > reach;
  }

  /// The least bound by the arc nearest to a point, at this distance, and one across from it, for
  /// points up to `reach` away; infinite if there are none.
  double boundBetween(const Arc& near, const Direction& place, double distance, double reach) {
    double least = std::numeric_limits<double>::infinity(), across = 0;
    if (!hasFeet(near, place, reach)) return least;
    const double own = dot(near.normal, place - near.a);
    for (const Arc& arc : arcs_) {
      if (!(dot(arc.normal, near.normal) < 0) || !hasFeet(arc, place, reach)) continue;
      const double other = dot(arc.normal, place - arc.a);
      if (!(other > 0)) continue;
      const double sine = (own + other + lengthOf(near.normal + arc.normal) * reach) / 2;
      const double bound = std::max(std::asin(std::min(sine, 1.0)), reach - distance);
      if (!(bound < least)) continue;
      least = bound;
      across = other;
    }
    if (across > 0) (void)lookAt(normalized(place + (across - own) / 2 * near.normal));
    return least;
  }

  /// The distance of a point from the border, as an angle; negative outside of the cell. nearest_
  /// becomes the arc with the foot, if that is not at an end.
  double distanceAt(const Direction& place) {
    double least = 1;  // the square of the sine of half the angle
    nearest_ = nullptr;
    for (const Arc& arc : arcs_) {
      const Direction fromA = place - arc.a, fromB = place - arc.b;
      const double toEnd = std::min(dot(fromA, fromA), dot(fromB, fromB)) / 4;
      if (toEnd < least) {
        least = toEnd;
        nearest_ = nullptr;
      }
      if (!(dot(arc.fromA, fromA) > 0) || !(dot(arc.fromB, fromB) > 0)) continue;
      const double sine = dot(arc.normal, fromA), square = std::min(sine * sine, 1.0);
      const double toFoot = square / (2 * (1 + std::sqrt(1 - square)));
      if (!(toFoot < least)) continue;
      least = toFoot;
      nearest_ = &arc;
    }
    const double angle = 2 * std::atan2(std::sqrt(least), std::sqrt(1 - least));
    return isInside(place) ? angle : -angle;
  }

  [[nodiscard]] bool isInside(const Direction& place) const {
    const Cap& own = diagram_.cap(node_);
    if (angleBetween(place, own.centre).angle() > most_) return false;
    const HalfAngle toOwn = distance(place, own);
    return std::none_of(neighbors_.begin(), neighbors_.end(),
                        [&](const Cap& other) { return distance(place, other) < toOwn; });
  }

  const ProjectedDiagram& diagram_;
  VertexId node_;
  const AngularReach& reach_;
  double most_;  // limit of the distance from the centre
  FlatArray<Cap> neighbors_;
  FlatArray<Arc> arcs_;
  FlatArray<Square> squares_;  // a heap
  const Arc* nearest_ = nullptr;
  InnerCircle best_;
};

}  // namespace

bool findInnerCircle(const ProjectedDiagram& diagram, VertexId node, const AngularReach& reach,
                     InnerCircle& circle) {
  return Search(diagram, node, reach).run(circle);
}

}  // namespace apollonius::internal::sphere
