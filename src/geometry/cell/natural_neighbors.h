// Natural neighbours (Sibson): from whose cells in a window a new circle would take something, and
// which share of its own cell from each.
//
// Nothing is inserted. The conflict region of the new circle q and the circles of the faces that
// would fill it say where the edges of q's cell would run, and which parts of today's edges lie in
// it: together they bound what q takes from each cell. By Green's theorem its area is a sum over
// these pieces, each of which adds to the cell on its left and takes away from the one on its
// right; so the pieces come in any order.
//
// The border of a rectangle is such a boundary, too. Let F(P) be the sum over the border from a
// fixed point on it to P, counter-clockwise. Where the border passes at P from what is taken of one
// cell to what is taken of another, F(P) is added to the first and subtracted from the second; the
// sum over the whole border is added to the cell that the fixed point is taken from. So the owner
// of only one point is ever looked up, and swapped contacts change the result by rounding only.
//
// In a region, this is enough for cells away from the border, which are most. For the others, a
// small diagram of the natural neighbours is clipped to the region, with q and without it.
#pragma once

#include <cstdint>
#include <span>

#include "base/flat_array.h"
#include "base/radix_sort.h"
#include "delaunay/conflict.h"
#include "diagram/diagram_core.h"
#include "geometry/curve/edge.h"
#include "geometry/window/polygon_clip.h"
#include "geometry/window/polygon_grid.h"
#include "geometry/window/rectangle_clip.h"
#include "predicate/circle_fan.h"

namespace apollonius::internal {

/// The share of the new cell that it takes from a site's cell.
struct NaturalShare {
  VertexId site;
  double weight;
};

/// New circles with which centres have natural neighbours.
enum class Centers : bool { kAll, kInWindow };

/// Keeps its scratch memory from one circle to the next.
class NaturalNeighbors {
 public:
  /// In a rectangle. REQUIRES: `core` lives as long.
  NaturalNeighbors(const DiagramCore& core, const Rectangle& window);
  /// In a region. REQUIRES: all live as long, and the diagram stays as it is.
  NaturalNeighbors(const ClippedDiagram& clippedDiagram, const PolygonGrid& border);

  /// Finds the natural neighbours of q; the weights are positive and add up to 1. A site that
  /// covers q is the only one; so is the nearest site if q is in the window but its cell is too
  /// thin for doubles. There are none if q's centre is not in the window (border included) for
  /// kInWindow, or if q's cell has no part in the window, up to rounding. REQUIRES: `start` is a
  /// visible site, close to q. Valid until the next call. Throws std::bad_alloc. Cost: a walk from
  /// `start`, and O(size of what would change); for a cell at the border of a region also O(points
  /// of the region) and a diagram of the natural neighbours.
  std::span<const NaturalShare> find(const Site& q, VertexId start, Centers centers);

 private:
  /// A point where q's cell or an edge in it meets the border.
  struct Contact {
    double position;  // Rectangle::positionOf
    Point point;
    // The sites from which q takes the border before and after it, counter-clockwise; kNoVertex
    // where the border is not in q's cell.
    VertexId before, after;
  };

  [[nodiscard]] VertexId findConflict(const Site& q, VertexId start);
  [[nodiscard]] bool isInWindow(const Site& q) const;
  void findNewVertices(const Site& q);
  void addNewEdges(const Site& q);
  void addOldEdges();
  [[nodiscard]] bool isSide(HalfedgeId h) const;
  [[nodiscard]] bool isEnough(const VoronoiCircle& circle, const Site& corner) const;
  [[nodiscard]] EdgeEnd oldVertex(FaceId f);
  void addOldEdge(HalfedgeId h, EdgeEnd from, EdgeEnd to);
  void addEdge(const Site& reference, const Site& other, EdgeEnd from, EdgeEnd to, VertexId left,
               VertexId right);
  void addPiece(const ClippedPiece& piece, VertexId left, VertexId right);
  void addContact(const Contact& contact);
  void addArea(VertexId site, double area);
  void addBorder(const Site& q);
  [[nodiscard]] double areaAlongBorder(const Contact& from, Point to, double length) const;
  [[nodiscard]] VertexId takenAt(const Site& q, Point p) const;
  void findInRegion(const Site& q, Centers centers);
  void findWithSmallDiagram(const Site& q);
  void expectShares(std::size_t most);
  void normalize();

  const DiagramCore& core_;
  const DelaunayGraph& delaunay_;
  const ClippedDiagram* clippedDiagram_ = nullptr;  // null in a rectangle
  const PolygonGrid* border_ = nullptr;
  Rectangle window_;  // or the box of the region
  Point origin_;      // areas are summed up about it: q's centre, if that is in the window

  ConflictSearch conflicts_;
  CircleFan fan_;
  FlatArray<VoronoiCircle> circles_;
  FlatArray<EdgeEnd> newVertices_;  // by side of the hole
  FlatArray<Keyed> sides_;  // half-edges of the hole's boundary, ascending, if it may have slits
  KeptVertices kept_;       // vertices whose cached circles are not accurate enough
  ClippedEdge clipped_;
  Rectangle extent_{};               // box of the pieces of q's boundary
  FlatArray<Contact> contacts_;      // by position
  FlatArray<NaturalShare> shares_;   // areas until they are normalized
  FlatArray<std::uint32_t> places_;  // hash table, open addressing: index in shares_ plus 1
};

/// Interpolates a field at points x, y, …, each the centre of a new circle of radius r: sums up the
/// natural neighbours' values, given by id, times their weights. NaN outside of the window and
/// without sites. `results` has one for each point. Throws std::bad_alloc.
void interpolate(const DiagramCore& core, NaturalNeighbors& neighbors,
                 std::span<const double> values, std::span<const double> xy, double r,
                 std::span<double> results);

}  // namespace apollonius::internal
