// Voronoi: checks bounds, ids and tolerances, turns lack of memory into an error, and leaves the
// work to src/geometry.
#include "apollonius/voronoi.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <vector>

#include "api/checks.h"
#include "api/shapes/region_state.h"
#include "diagram/listing.h"
#include "geometry/clipping/cell_drawing.h"
#include "geometry/clipping/edge_graph.h"
#include "geometry/clipping/reach_clipping.h"
#include "geometry/clipping/rectangle_clipping.h"
#include "geometry/curve/moments.h"
#include "geometry/draw/hull.h"
#include "geometry/draw/path_writer.h"
#include "geometry/draw/render.h"
#include "geometry/inscribed/empty_circles.h"
#include "geometry/inscribed/inner_circle.h"
#include "geometry/polygons/cell_polygon.h"
#include "geometry/polygons/coverage.h"

namespace apollonius {

using namespace internal;

namespace {

Rectangle windowOf(const Bounds& b) { return {b.xmin, b.ymin, b.xmax, b.ymax}; }

bool areGood(const Bounds& b) {
  return isInRange(b.xmin) && isInRange(b.ymin) && isInRange(b.xmax) && isInRange(b.ymax) &&
         b.xmin < b.xmax && b.ymin < b.ymax;
}

constexpr double kShareOfWindow = powerOfTwo(-13);

void appendCurve(const Conic& c, std::vector<double>& curves) {
  curves.insert(curves.end(), {c.p0.x, c.p0.y, c.p1.x, c.p1.y, c.w, c.p2.x, c.p2.y});
}

class EdgeLister final : public EdgeVisitor {  // NOLINT: nothing derives from it
 public:
  EdgeLister(const DiagramCore& core, CurveArrays& edges) : core_(core), edges_(edges) {}
  void visit(HalfedgeId h, const EdgePart& piece) override {
    const Graph& graph = core_.delaunay().graph();
    appendCurve(piece.curve, edges_.curves);
    edges_.sites.push_back(core_.siteOf(graph.origin(h)));
    edges_.sites.push_back(core_.siteOf(graph.target(h)));
  }

 private:
  const DiagramCore& core_;
  CurveArrays& edges_;
};

/// Moments of the area inside a closed boundary; `origin` should be near it.
CellMoments momentsOf(std::span<const BoundaryPiece> boundary, Point origin) {
  Moments sum;
  for (const BoundaryPiece& piece : boundary) sum.add(piece.curve, origin);
  CellMoments moments;
  moments.area = std::max(0.0, sum.area);
  moments.isEmpty = !(sum.area > 0);
  if (moments.isEmpty) return moments;
  moments.centroidX = origin.x + sum.first.x / sum.area;
  moments.centroidY = origin.y + sum.first.y / sum.area;
  return moments;
}

CellMeasures measuresOf(std::span<const BoundaryPiece> boundary, Point origin) {
  CellMeasures measures;
  static_cast<CellMoments&>(measures) = momentsOf(boundary, origin);
  for (const BoundaryPiece& piece : boundary) measures.perimeter += lengthOf(piece.curve);
  return measures;
}

/// To RingArrays or CoverageArrays.
template <class Arrays>
void assign(Arrays& arrays, const Rings& rings) {
  arrays.coordinates.assign(rings.coordinates.begin(), rings.coordinates.end());
  arrays.starts.assign(rings.starts.begin(), rings.starts.end());
  arrays.parts.assign(rings.parts.begin(), rings.parts.end());
}

void assign(CoverageArrays& arrays, const Coverage& coverage) {
  assign(arrays, coverage.rings);
  arrays.sites.assign(coverage.sites.begin(), coverage.sites.end());
  arrays.cells.assign(coverage.cells.begin(), coverage.cells.end());
}

Point centerOf(const DiagramCore& core, Slot slot) {
  return {core.site(slot).x, core.site(slot).y};
}

Error toleranceError(double tolerance) {
  if (!std::isfinite(tolerance)) return Error::kNotFinite;
  return tolerance >= 0 ? Error::kNone : Error::kOutOfRange;
}

Tolerance toleranceIn(const Bounds& window, double given) {
  return given > 0 ? Tolerance{given} : Tolerance{defaultTolerance(window), kDefaultShare};
}

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();
constexpr Circle kNoCircle{kNoNumber, kNoNumber, kNoNumber};

Error aspectError(double aspect) {
  if (!std::isfinite(aspect)) return Error::kNotFinite;
  return aspect >= 1 / kMostAspect && aspect <= kMostAspect ? Error::kNone : Error::kOutOfRange;
}

/// The largest circle inside a cell, if that has a part; false if the search does not end. `curves`
/// is scratch.
bool findIn(const Cell& cell, double aspect, InnerCircleFinder& finder, FlatArray<Conic>& curves,
            Circle& circle) {
  if (cell.pieces.empty()) return true;
  copyCurves(cell, curves);
  Place place;
  const bool isFound = finder.find(curves, cell.starts, aspect, place);
  circle = {place.at.x, place.at.y, place.r};
  return isFound;
}

}  // namespace

Error innerCircle(std::span<const double> curves, std::span<const std::uint32_t> starts,
                  double aspect, Circle& circle) {
  circle = kNoCircle;
  constexpr std::size_t kOfCurve = 7;
  bool isGood = curves.size() % kOfCurve == 0 && !starts.empty() && starts.front() == 0 &&
                starts.back() == curves.size() / kOfCurve;
  for (std::size_t k = 1; k < starts.size(); ++k) isGood = isGood && starts[k] > starts[k - 1];
  const Error error =
      firstOf(isGood ? Error::kNone : Error::kBadLength, aspectError(aspect), checkNumbers(curves));
  if (error != Error::kNone || curves.empty()) return error;
  try {
    FlatArray<Conic> outline;
    for (std::size_t k = 0; k < curves.size(); k += kOfCurve) {
      const double* at = &curves[k];
      outline.push_back({{at[0], at[1]}, {at[2], at[3]}, at[4], {at[5], at[6]}});
    }
    InnerCircleFinder finder;
    Place place;
    if (!finder.find(outline, starts, aspect, place)) return Error::kNoConvergence;
    circle = {place.at.x, place.at.y, place.r};
    return Error::kNone;
  } catch (const std::bad_alloc&) {
    return Error::kOutOfMemory;
  }
}

Bounds Voronoi::extentOf(const Diagram& diagram) {
  const DiagramCore& core = *diagram.core_;
  constexpr double kNone = std::numeric_limits<double>::infinity();
  Bounds box{kNone, kNone, -kNone, -kNone};
  for (Slot slot = 0; slot < core.ids().slots(); ++slot) {
    if (core.ids().state(slot) == SiteState::kFree) continue;
    const Site& site = core.site(slot);
    const double r = std::max(site.r, 0.0);
    box = {std::min(box.xmin, site.x - r), std::min(box.ymin, site.y - r),
           std::max(box.xmax, site.x + r), std::max(box.ymax, site.y + r)};
  }
  if (!(box.xmin <= box.xmax)) return {};
  const auto widen = [](double& low, double& high) {
    if (!(low < high)) {
      const double pad = low == 0 ? 1 : absolute(low) / 2;
      low -= pad;
      high += pad;
    }
    for (double* end : {&low, &high})
      *end = std::clamp(taken(*end), -kLargestMagnitude, kLargestMagnitude);
  };
  widen(box.xmin, box.xmax);
  widen(box.ymin, box.ymax);
  return areGood(box) ? box : Bounds{};
}

double defaultTolerance(const Bounds& bounds) {
  return kShareOfWindow * windowOf(bounds).diagonal();
}

std::uint32_t Voronoi::slotOf(SiteId id) const { return diagram_.core_->ids().slotOf(id); }

Error Voronoi::windowError() const {
  const bool isGood = region_ != nullptr ? region_->state_ != nullptr : areGood(bounds_);
  if (!isGood) return Error::kBadBounds;
  if (reach_ == nullptr) return Error::kNone;
  if (reach_->hasNaN()) return Error::kNotFinite;
  return reach_->isOutOfRange() ? Error::kOutOfRange : Error::kNone;
}

Error Voronoi::siteError(SiteId id) const {
  return diagram_.has(id) ? Error::kNone : Error::kUnknownSite;
}

template <class Operation>
Error Voronoi::guarded(Error before, Operation&& operation) const {
  return internal::guarded(*diagram_.core_, before, operation);
}

template <class Operation>
Error Voronoi::clipped(Error before, Operation&& operation) const {
  return guarded(before, [&] {
    const DiagramCore& core = *diagram_.core_;
    const auto reached = [&](const Clipping& clipping) {
      if (reach_ == nullptr || reach_->isUnlimited()) return operation(clipping);
      operation(ReachClipping(core, clipping, *reach_));
    };
    if (region_ == nullptr) {
      reached(RectangleClipping(core, windowOf(bounds_)));
    } else {
      reached(region_->state_->clippingOf(core, diagram_.state_));
    }
  });
}

template <class Operation>
Error Voronoi::withCell(SiteId id, Error tolerance, Operation&& operation) const {
  return clipped(firstOf(windowError(), siteError(id), tolerance), [&](const Clipping& clipping) {
    const auto cells = clipping.cells(Parts::kWithArea);
    const Slot slot = slotOf(id);
    const Cell& cell = cells->find(slot);
    operation(cell, clipping.box().nearestTo(centerOf(*diagram_.core_, slot)));
  });
}

Error Voronoi::edgeCurves(CurveArrays& edges) const {
  return clipped(windowError(), [&](const Clipping& clipping) {
    edges = {};
    EdgeLister lister(*diagram_.core_, edges);
    clipping.visitEdges(lister);
  });
}

Error Voronoi::edgeGraph(EdgeGraph& graph) const {
  return clipped(windowError(), [&](const Clipping& clipping) {
    listEdgeGraph(*diagram_.core_, clipping, graph.vertices, graph.edges, graph.narrowest);
  });
}

Error Voronoi::cellCurves(SiteId id, CurveArrays& boundary) const {
  return withCell(id, Error::kNone, [&](const Cell& cell, Point) {
    boundary.curves.clear();
    boundary.sites.clear();
    for (const BoundaryPiece& piece : cell.pieces) {
      appendCurve(piece.curve, boundary.curves);
      boundary.sites.push_back(piece.sharedWith());
    }
    boundary.starts.assign(cell.starts.begin(), cell.starts.end());
  });
}

Error Voronoi::neighbors(SiteId id, std::vector<SiteId>& neighbors) const {
  return clipped(firstOf(windowError(), siteError(id)), [&](const Clipping& clipping) {
    // An edge is in thin parts of both its cells, whether or not these have an area.
    const auto cells = clipping.cells(Parts::kThinToo);
    neighbors.clear();
    for (const BoundaryPiece& piece : cells->find(slotOf(id)).pieces) {
      if (piece.sharedWith() != kNoSite) neighbors.push_back(piece.sharedWith());
    }
    keepFirstOccurrences(neighbors);
  });
}

Error Voronoi::cellPolygon(SiteId id, double tolerance, RingArrays& rings) const {
  const Error error = firstOf(windowError(), siteError(id), toleranceError(tolerance));
  return clipped(error, [&](const Clipping& clipping) {
    const auto cells = clipping.cells(Parts::kWithArea);
    PolygonFinder finder(*diagram_.core_, *cells, clipping.border(),
                         toleranceIn(bounds_, tolerance));
    Rings found;
    finder.find(slotOf(id), found);
    assign(rings, found);
  });
}

Error Voronoi::cellPolygonsBetween(SiteId first, SiteId end, double tolerance,
                                   CoverageArrays& polygons) const {
  return clipped(firstOf(windowError(), toleranceError(tolerance)), [&](const Clipping& clipping) {
    const auto cells = clipping.cells(Parts::kWithArea);
    PolygonFinder finder(*diagram_.core_, *cells, clipping.border(),
                         toleranceIn(bounds_, tolerance));
    Coverage found;
    assemble(listCells(*diagram_.core_, finder, RingsAre::kPolygons, first, end), found);
    assign(polygons, found);
  });
}

Error Voronoi::cellPolygons(double tolerance, CoverageArrays& coverage,
                            std::span<const std::uint32_t> groups) const {
  bool isCovered = true;
  const bool isFilled = reach_ == nullptr || reach_->isUnlimited();
  const Error before = firstOf(windowError(), toleranceError(tolerance));
  const Error error = clipped(before, [&](const Clipping& clipping) {
    const double area = !isFilled            ? std::numeric_limits<double>::quiet_NaN()
                        : region_ != nullptr ? region_->area()
                                             : clipping.box().width() * clipping.box().height();
    const auto cells = clipping.cells(Parts::kThinToo);
    PolygonFinder finder(*diagram_.core_, *cells, clipping.border(),
                         toleranceIn(bounds_, tolerance));
    Coverage found;
    isCovered = coverWindow(*diagram_.core_, finder, clipping.box(), area, groups, found);
    if (!isCovered) return;
    assign(coverage, found);
  });
  if (error != Error::kNone || isCovered) return error;
  // An unverified snapshot may hold an invalid diagram.
  return diagram_.core_->delaunay().isProven() ? Error::kBroken : Error::kCorruptSnapshot;
}

Error Voronoi::cellMoments(SiteId id, CellMoments& moments) const {
  return withCell(id, Error::kNone, [&](const Cell& cell, Point origin) {
    moments = momentsOf(cell.pieces, origin);
  });
}

Error Voronoi::cellMeasures(SiteId id, CellMeasures& measures) const {
  return withCell(id, Error::kNone, [&](const Cell& cell, Point origin) {
    measures = measuresOf(cell.pieces, origin);
  });
}

Error Voronoi::measureAll(internal::Measure what, std::vector<double>& measures) const {
  return clipped(windowError(),
                 [&](const Clipping& clipping) { clipping.measureCells(what, measures); });
}

Error Voronoi::cellAreas(std::vector<double>& areas) const {
  return measureAll(Measure::kAreas, areas);
}

Error Voronoi::cellCentroids(std::vector<double>& centroids) const {
  return measureAll(Measure::kCentroids, centroids);
}

Error Voronoi::cellPerimeters(std::vector<double>& perimeters) const {
  return measureAll(Measure::kPerimeters, perimeters);
}

Error Voronoi::cellCircle(SiteId id, double aspect, Circle& circle) const {
  circle = kNoCircle;
  std::vector<double> one;
  const Error error = firstOf(windowError(), siteError(id));
  if (error != Error::kNone) return error;
  if (const Error failed = cellCirclesBetween(id, id + 1, aspect, one); failed != Error::kNone)
    return failed;
  circle = {one[0], one[1], one[2]};
  return Error::kNone;
}

Error Voronoi::cellCirclesBetween(SiteId first, SiteId end, double aspect,
                                  std::vector<double>& circles) const {
  bool isFound = true;
  const Error before = firstOf(windowError(), aspectError(aspect));
  const Error error = clipped(before, [&](const Clipping& clipping) {
    const IdPool& ids = diagram_.core_->ids();
    const auto last = std::min<std::size_t>(end, ids.idLimit());
    circles.assign(last > first ? 3 * (last - first) : 0, kNoCircle.r);
    const auto cells = clipping.cells(Parts::kWithArea);
    InnerCircleFinder finder;
    FlatArray<Conic> curves;
    for (SiteId id = first; id < last && isFound; ++id) {
      const Slot slot = ids.slotOf(id);
      if (slot == kNoSlot) continue;
      Circle circle = kNoCircle;
      isFound = findIn(cells->find(slot), aspect, finder, curves, circle);
      double* const at = &circles[3 * std::size_t{id - first}];
      at[0] = circle.x;
      at[1] = circle.y;
      at[2] = circle.r;
    }
  });
  return error == Error::kNone && !isFound ? Error::kNoConvergence : error;
}

Error Voronoi::emptyCircles(std::size_t most, bool inside, VertexArrays& circles) const {
  if (reach_ != nullptr) {
    const Voronoi whole =
        region_ != nullptr ? Voronoi(diagram_, *region_) : Voronoi(diagram_, bounds_);
    return whole.emptyCircles(most, inside, circles);
  }
  bool isFound = true;
  const Error error = clipped(windowError(), [&](const Clipping& clipping) {
    isFound = listEmptyCircles(*diagram_.core_, clipping, most, inside, circles);
  });
  return error == Error::kNone && !isFound ? Error::kNoConvergence : error;
}

Error Voronoi::naturalWeights(double x, double y, double r, NaturalWeights& found) const {
  const Error bad = firstOf(takeNumber(x), takeNumber(y), takeNumber(r));
  return clipped(firstOf(windowError(), bad), [&](const Clipping& clipping) {
    const DiagramCore& core = *diagram_.core_;
    found = {};
    if (core.visibleCount() == 0) return;
    const auto neighbors = clipping.naturalNeighbors();
    const VertexId start = vertexOf(core.nearest(x, y));
    for (const auto& [site, weight] : neighbors->find({x, y, r}, start, Centers::kAll)) {
      found.ids.push_back(core.siteOf(site));
      found.weights.push_back(weight);
    }
  });
}

Error Voronoi::interpolate(std::span<const double> values, std::span<const double> xy, double r,
                           std::span<double> results) const {
  const DiagramCore& core = *diagram_.core_;
  const bool areLengthsGood =
      values.size() == core.ids().idLimit() && xy.size() == 2 * results.size();
  const Error error = firstOf(windowError(), areLengthsGood ? Error::kNone : Error::kBadLength,
                              firstOf(takeNumber(r), checkNumbers(xy)));
  return clipped(error, [&](const Clipping& clipping) {
    internal::interpolate(core, *clipping.naturalNeighbors(), values, TakenNumbers(xy), r, results);
  });
}

Error Voronoi::drawEdges(double tolerance, Portion& portion, Path& path) const {
  const Error error = firstOf(windowError(), toleranceError(tolerance));
  return clipped(error, [&](const Clipping& clipping) {
    path.clear();
    clipping.drawEdges(toleranceIn(bounds_, tolerance), portion, path);
  });
}

Error Voronoi::drawSites(double tolerance, Portion& portion, Path& path) const {
  return guarded(firstOf(windowError(), toleranceError(tolerance)), [&] {
    path.clear();
    internal::drawSites(*diagram_.core_, toleranceIn(bounds_, tolerance), portion, path);
  });
}

Error Voronoi::drawDual(double tolerance, bool rays, Portion& portion, Path& path) const {
  return guarded(firstOf(windowError(), toleranceError(tolerance)), [&] {
    path.clear();
    const Rectangle window = windowOf(bounds_);
    internal::drawDual(*diagram_.core_, rays ? &window : nullptr, toleranceIn(bounds_, tolerance),
                       portion, path);
  });
}

Error Voronoi::drawCell(SiteId id, double tolerance, Path& path) const {
  return withCell(id, toleranceError(tolerance), [&](const Cell& cell, Point) {
    path.clear();
    internal::drawCell(cell, toleranceIn(bounds_, tolerance), path);
  });
}

Error Voronoi::drawCells(double tolerance, Portion& portion, CellDrawings& cells) const {
  const Error error = firstOf(windowError(), toleranceError(tolerance));
  return clipped(error, [&](const Clipping& clipping) {
    internal::drawCells(*diagram_.core_, clipping, toleranceIn(bounds_, tolerance), portion, cells);
  });
}

Error Voronoi::cellPaths(double tolerance, unsigned digits, Portion& portion,
                         CellPaths& paths) const {
  const Error error =
      firstOf(windowError(), toleranceError(tolerance),
              digits <= PathWriter::kMostDigits ? Error::kNone : Error::kOutOfRange);
  return clipped(error, [&](const Clipping& clipping) {
    writeCells(*diagram_.core_, clipping, toleranceIn(bounds_, tolerance), digits, portion, paths);
  });
}

Error Voronoi::drawHull(double tolerance, Path& path) const {
  return guarded(firstOf(windowError(), toleranceError(tolerance)), [&] {
    path.clear();
    internal::drawHull(*diagram_.core_, toleranceIn(bounds_, tolerance), path);
  });
}

}  // namespace apollonius
