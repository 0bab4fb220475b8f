// The geometry of a diagram: its true, curved cells inside a window, as shapes, measures and
// drawings; the dual graph and the hull drawn.
//
// A Voronoi edge is a piece of a hyperbola branch with its foci at the two centres (of a line, if
// the weights are equal). Every curve that is handed out is a rational quadratic Bezier curve,
// which such a piece is exactly: seven numbers x0, y0, x1, y1, w, x2, y2 for
//
//     P(t) = ((1-t)² P0 + 2 w t (1-t) P1 + t² P2) / ((1-t)² + 2 w t (1-t) + t²),   0 <= t <= 1,
//
// w > 1 for a hyperbola; w = 0 for a straight segment. Where two cells meet, both have the same
// curve, bit for bit; and all numbers are the same bits natively and as WebAssembly. In a
// rectangle, curves have the same bits after any history, too, and a cell has them in the same
// order; in other windows, too, except where a ring passes through a Voronoi vertex. Drawings and
// sums (areas, centroids, lengths) may differ in the last places.
//
// The window is a rectangle, or of any shape (apollonius/region.h). A rectangle is convex and a
// cell is star-shaped, so the clipped cell is a number of *parts* without holes: one if its centre
// is in the window, perhaps several if not. In other windows parts have holes. What only touches
// the window is not in it.
//
// As in apollonius/diagram.h, no call throws; a failed one returns its Error. A Region caches its
// crossings with the diagram that it was last used with. A Voronoi is a view: it shows the diagram
// as it is at each call, and must not outlive it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "apollonius/bounds.h"
#include "apollonius/diagram.h"
#include "apollonius/export.h"
#include "apollonius/path.h"
#include "apollonius/reach.h"
#include "apollonius/region.h"

namespace apollonius {

namespace internal {
class Clipping;
enum class Measure : unsigned char;
}  // namespace internal

/// Curves, seven numbers each, and the site on the right of each (kNoSite: the window's border; for
/// edges(): two sites a curve, the first one on the left).
struct CurveArrays {
  std::vector<double> curves;
  std::vector<std::uint32_t> sites;
  std::vector<std::uint32_t>
      starts;  ///< for a cell: the first curve of each ring, and the number of curves at the end
};

/// The edges inside a window as a graph: edge k is curve k of Voronoi::edgeCurves().
struct EdgeGraph {
  /// The ends of the edges: Voronoi vertices, and where an edge is cut, at the border or at a
  /// reach, a vertex of its two sites, the third one being kNoSite. A Voronoi vertex of more than
  /// three sites is one row, and three of these are named.
  VertexArrays vertices;
  EdgeArrays edges;  ///< none is unbounded
  /// As Diagram::narrowest, for these edges.
  VertexArrays narrowest;
};

/// Closed rings (the first point is repeated at the end), counter-clockwise; those of holes are
/// clockwise and follow the ring that they are in.
struct RingArrays {
  std::vector<double> coordinates;  ///< x, y of each point
  std::vector<std::uint32_t>
      starts;  ///< the first point of each ring, and the number of points at the end
  std::vector<std::uint32_t>
      parts;  ///< the first ring of each part, and the number of rings at the end
};

/// Such rings of all cells, one after the other.
struct CoverageArrays {
  std::vector<double> coordinates;    ///< as in RingArrays
  std::vector<std::uint32_t> starts;  ///< as in RingArrays
  std::vector<std::uint32_t> parts;   ///< as in RingArrays
  std::vector<std::uint32_t> sites;   ///< those that have a part, or groups of sites; ascending
  std::vector<std::uint32_t>
      cells;  ///< the first part of each of these, and the number of parts at the end
};

/// Moments of a cell inside the window. If it is empty, all numbers are 0.
struct CellMoments {
  double area = 0;  ///< relative error a few units in the last place for cells of the window's size
  double centroidX = 0;
  double centroidY = 0;
  bool isEmpty = true;  ///< no part of it is in the window, or the site is hidden
};
struct CellMeasures : CellMoments {
  double perimeter = 0;  ///< the window's border included
};

/// The sites from whose cells a new circle would take a part, and each part's share of the new
/// cell. The shares add up to 1.
struct NaturalWeights {
  std::vector<SiteId> ids;
  std::vector<double> weights;
};

/// A tolerance for drawings that is too small to be seen: 2^-13 of the window's diagonal.
[[nodiscard]] APOLLONIUS_EXPORT double defaultTolerance(const Bounds& bounds);

/// The largest aspect of an ellipse inside; 1 / kMostAspect is the smallest.
inline constexpr double kMostAspect = 1000;

/// The largest circle inside rings of curves that do not cross, seven numbers each; starts[k] is
/// the first curve of ring k, and the last entry the number of curves. As Voronoi::cellCircle();
/// NaN without curves. Errors: kBadLength unless lengths and starts fit, kNotFinite, kOutOfRange,
/// kNoConvergence, kOutOfMemory.
[[nodiscard]] APOLLONIUS_EXPORT Error innerCircle(std::span<const double> curves,
                                                  std::span<const std::uint32_t> starts,
                                                  double aspect, Circle& circle);

class APOLLONIUS_EXPORT Voronoi {
 public:
  // With a reach, which must live as long, all cells below end at its distances from their sites'
  // circles, and edges are what two of these cells share. Calls return kNotFinite or kOutOfRange if
  // the reach has such a distance, kBadLength if it has none for an id.
  explicit Voronoi(const Diagram& diagram, const Bounds& bounds = {}, const Reach* reach = nullptr)
      : diagram_(diagram),
        bounds_{taken(bounds.xmin), taken(bounds.ymin), taken(bounds.xmax), taken(bounds.ymax)},
        reach_(reach) {}
  /// The window is a region, which must live as long. The first call after region or diagram has
  /// changed costs O(h), and about the logarithm of its degree for each cell that a side passes
  /// through. A side that is about as near to many cells as to the border of its own costs their
  /// number.
  Voronoi(const Diagram& diagram, const Region& region, const Reach* reach = nullptr)
      : diagram_(diagram), bounds_(region.box()), region_(&region), reach_(reach) {}

  // Every call below can return kBadBounds (unless xmin < xmax, ymin < ymax, all within the range
  // of coordinates) and kOutOfMemory, and replaces the contents of its last argument. Those with a
  // site: kUnknownSite; a hidden one has an empty cell. Those with a tolerance (largest distance of
  // a drawn line from the true one): kNotFinite, kOutOfRange unless it is >= 0. Below 2^-36 of a
  // curve's size it has no further effect. 0 is the default: that of defaultTolerance(), and less
  // where a cell is small: polygons are then within 0.5 % of their cells' areas.

  /// Each Voronoi edge inside the window, its pieces one by one.
  [[nodiscard]] Error edgeCurves(CurveArrays& edges) const;
  /// The Voronoi edges inside the window as a graph.
  [[nodiscard]] Error edgeGraph(EdgeGraph& graph) const;
  /// The boundary of a cell, counter-clockwise, part by part. Cost: O(d log d).
  [[nodiscard]] Error cellCurves(SiteId id, CurveArrays& boundary) const;
  /// The sites whose cells have an edge in common with this one's inside the window: those of the
  /// pieces of edgeCurves() on both sides, so each of two neighbours has the other. In the order of
  /// the boundary, each once. Cost: O(d log d).
  [[nodiscard]] Error neighbors(SiteId id, std::vector<SiteId>& neighbors) const;
  /// The boundary of a cell as polygons that are valid in the sense of OGC's Simple Features,
  /// whatever the tolerance: rings do not cross, and pass no point twice. Neighbours have the
  /// points of their edge in common, except some that rounding has put out of order. A part about
  /// as small as the spacing of doubles there has no ring.
  [[nodiscard]] Error cellPolygon(SiteId id, double tolerance, RingArrays& rings) const;
  /// The polygons of all cells. They tile the window: each segment occurs once, and its reverse
  /// once in the cell beside it, or it lies on the border; and segments meet in common ends only.
  /// This is proved, and the sum of the areas is compared with the window's. Errors also: kBroken,
  /// a defect of the library (after a trusted snapshot kCorruptSnapshot, a defect of its bytes).
  /// Cost: O(n) for sites spread evenly, less than a loop of cellPolygon.
  ///
  /// `groups` may have the number of a group for each id. Then the cells of a group are united:
  /// segments between two of them are left out. Sites with kNoGroup, and those beyond the end of
  /// `groups`, have no polygon. Cost then: O(m log m) for m points.
  [[nodiscard]] Error cellPolygons(double tolerance, CoverageArrays& coverage,
                                   std::span<const std::uint32_t> groups = {}) const;
  /// The polygons of the sites with ids from `first` to before `end`, each as cellPolygon() gives
  /// it: many at a time, but not all at once.
  [[nodiscard]] Error cellPolygonsBetween(SiteId first, SiteId end, double tolerance,
                                          CoverageArrays& polygons) const;
  /// Area and centroid; cellMeasures() takes several times as long, for the perimeter.
  [[nodiscard]] Error cellMoments(SiteId id, CellMoments& moments) const;
  [[nodiscard]] Error cellMeasures(SiteId id, CellMeasures& measures) const;
  /// The area of every cell, by id; 0 for ids without one. They add up to the window's, to
  /// rounding: of the coordinates, too, where the window is only a few doubles wide. Cost: O(h)
  [[nodiscard]] Error cellAreas(std::vector<double>& areas) const;
  /// The centroid of every cell, x and y by id; NaN for ids without a cell in the window. Cost:
  /// O(h)
  [[nodiscard]] Error cellCentroids(std::vector<double>& centroids) const;
  /// The perimeter of every cell, by id; 0 for ids without one. Cost: O(h)
  [[nodiscard]] Error cellPerimeters(std::vector<double>& perimeters) const;

  // Circles inside, and empty ones. Errors also: kNoConvergence if a border that touches itself up
  // to rounding keeps the search from ending.

  /// The largest circle inside a cell: r is at least 0.999 of the largest possible, and the circle
  /// is inside up to rounding. NaN if no part of the cell is in the window. With an aspect other
  /// than 1, the largest ellipse whose width is this many times its height: r is half its height.
  /// Errors also: kNotFinite, kOutOfRange unless the aspect is from 1 / kMostAspect to kMostAspect.
  /// Cost: O(d log d), with a constant of some ten looks, or some thousand in long thin rings.
  [[nodiscard]] Error cellCircle(SiteId id, double aspect, Circle& circle) const;
  /// The circles of the sites with ids from `first` to before `end`, x, y and r of each; NaN for
  /// ids without one. Cost: that of cellCircle() for each.
  [[nodiscard]] Error cellCirclesBetween(SiteId first, SiteId end, double aspect,
                                         std::vector<double>& circles) const;
  /// The `most` largest circles that no site reaches into, with their centres in the window, the
  /// largest first, none with its centre in one before it. Each row has the centre, the distance to
  /// the nearest site (below 0 if sites cover the window), and one site, the nearest. With
  /// `inside`, only circles that do not cross the window's border: they are chosen from the circles
  /// about Voronoi vertices and the largest one of each cell at the border, whose r is at least
  /// 0.999 of the largest possible. A reach is ignored. Cost: O(n (log n + most)); with `inside`
  /// also that of cellCircle() for each cell at the border that is searched.
  [[nodiscard]] Error emptyCircles(std::size_t most, bool inside, VertexArrays& circles) const;

  /// The natural neighbours of a new circle (Sibson): the sites from whose cells in the window it
  /// would take a part, and each part's share of the new cell. A site that covers it is the only
  /// one. None without sites, or if the new cell would have no part in the window. The diagram
  /// stays as it is; a reach is ignored. Errors also: kNotFinite, kOutOfRange. Cost: location, and
  /// O(s), s the size of the change; at the border of a region also O(points of the region) and a
  /// diagram of the natural neighbours.
  [[nodiscard]] Error naturalWeights(double x, double y, double r, NaturalWeights& found) const;
  /// Values of a field at points x, y, …: sums of `values`, given by id, times the naturalWeights()
  /// of a circle of radius r there. NaN outside of the window and without sites. Fills `results`,
  /// one for each point. Errors also: kNotFinite, kOutOfRange, kBadLength unless there is a value
  /// for each id that was ever used and a result for each point. Cost: as naturalWeights(), with
  /// less for location, as points are visited along a curve.
  [[nodiscard]] Error interpolate(std::span<const double> values, std::span<const double> xy,
                                  double r, std::span<double> results) const;

  /// The box of all circles (for negative radii, of their centres), a little larger if it would be
  /// empty: for drawings without a window.
  [[nodiscard]] static Bounds extentOf(const Diagram& diagram);

  // Drawings in portions (apollonius/path.h).
  [[nodiscard]] Error drawEdges(double tolerance, Portion& portion, Path& path) const;
  [[nodiscard]] Error drawSites(double tolerance, Portion& portion, Path& path) const;
  /// The dual graph as the paper's Appendix A embeds it, not clipped; with `rays` also those to
  /// infinity, cut at the window.
  [[nodiscard]] Error drawDual(double tolerance, bool rays, Portion& portion, Path& path) const;
  /// A cell as closed figures, one for each ring.
  [[nodiscard]] Error drawCell(SiteId id, double tolerance, Path& path) const;
  /// A portion of all cells, in any order, each as drawCell() draws it. Cost: O(h) for sites spread
  /// evenly.
  [[nodiscard]] Error drawCells(double tolerance, Portion& portion, CellDrawings& cells) const;
  /// A portion of all cells as text. Numbers are rounded to `digits` decimal places (kOutOfRange
  /// above 15) and written as JavaScript writes them. If one has more than 15 digits then, there
  /// are no cells, and the portion is not done.
  [[nodiscard]] Error cellPaths(double tolerance, unsigned digits, Portion& portion,
                                CellPaths& paths) const;
  [[nodiscard]] Error drawHull(double tolerance, Path& path) const;

 private:
  [[nodiscard]] std::uint32_t slotOf(SiteId id) const;  // in the core
  [[nodiscard]] Error windowError() const;
  [[nodiscard]] Error siteError(SiteId id) const;
  /// Runs the operation unless there is an error before; turns lack of memory into an error.
  template <class Operation>
  [[nodiscard]] Error guarded(Error before, Operation&& operation) const;
  /// Runs operation(const internal::Clipping&) unless there is an error before or of the window;
  /// turns lack of memory into an error.
  template <class Operation>
  [[nodiscard]] Error clipped(Error before, Operation&& operation) const;
  /// Runs operation(the site's cell, the point of the window's box nearest to its centre), unless
  /// there is an error of the window, the site or the tolerance.
  template <class Operation>
  [[nodiscard]] Error withCell(SiteId id, Error tolerance, Operation&& operation) const;
  [[nodiscard]] Error measureAll(internal::Measure what, std::vector<double>& measures) const;

  const Diagram& diagram_;
  Bounds bounds_;  // the region's, if there is one
  const Region* region_ = nullptr;
  const Reach* reach_;
};

}  // namespace apollonius
