// Voronoi: checks bounds, ids and tolerances, turns lack of memory into an error, and leaves the
// work to src/geometry.
#include "apollonius/voronoi.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "api/checks.h"
#include "api/region_state.h"
#include "base/flat_array.h"
#include "geometry/cell/cell_measures.h"
#include "geometry/cell/disc_cell.h"
#include "geometry/cell/polygon_cell.h"
#include "geometry/cell/rectangle_cell.h"
#include "geometry/curve/moments.h"
#include "geometry/draw/cubics.h"
#include "geometry/draw/hull.h"
#include "geometry/draw/render.h"
#include "geometry/polygons/cell_polygon.h"
#include "geometry/polygons/coverage.h"

namespace apollonius {

using namespace internal;

namespace {

Rectangle windowOf(const Bounds& b) { return {b.xmin, b.ymin, b.xmax, b.ymax}; }

bool areGood(const Bounds& b) {
  for (const double x : {b.xmin, b.ymin, b.xmax, b.ymax}) {
    const double magnitude = std::abs(x);
    if (!(magnitude == 0 || (magnitude >= kSmallestMagnitude && magnitude <= kLargestMagnitude)))
      return false;
  }
  return b.xmin < b.xmax && b.ymin < b.ymax;
}

constexpr double kDefaultShare = powerOfTwo(-13);

void appendCurve(const Conic& c, std::vector<double>& curves) {
  curves.insert(curves.end(), {c.p0.x, c.p0.y, c.p1.x, c.p1.y, c.w, c.p2.x, c.p2.y});
}

void addUp(std::span<const BoundaryPiece> boundary, Point origin, Moments& moments,
           CellMeasures& measures) {
  for (const BoundaryPiece& piece : boundary) {
    moments.add(piece.curve, origin);
    measures.perimeter += lengthOf(piece.curve);
  }
}

void drawClosed(std::span<const BoundaryPiece> ring, double tolerance, Path& path) {
  const Point start = ring.front().curve.p0;
  path.move(start.x, start.y);
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Conic& curve = ring[k].curve;
    const bool isClosing = k + 1 == ring.size() && curve.isStraight();  // close() draws it
    if (!isClosing && !(curve.p0 == curve.p2)) drawConic(curve, tolerance, path);
  }
  path.close();
}

/// To RingArrays or CoverageArrays.
template <class Arrays>
void assign(Arrays& arrays, const Rings& rings) {
  arrays.coordinates.assign(rings.coordinates.begin(), rings.coordinates.end());
  arrays.starts.assign(rings.starts.begin(), rings.starts.end());
  arrays.parts.assign(rings.parts.begin(), rings.parts.end());
}

void finish(const Moments& moments, Point origin, CellMeasures& measures) {
  measures.isEmpty = !(moments.area > 0);
  measures.area = std::max(0.0, moments.area);
  if (measures.isEmpty) return;
  measures.centroidX = origin.x + moments.first.x / moments.area;
  measures.centroidY = origin.y + moments.first.y / moments.area;
}

}  // namespace

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
    const auto inRange = [](double x) {
      return absolute(x) < kSmallestMagnitude
                 ? 0.0
                 : std::clamp(x, -kLargestMagnitude, kLargestMagnitude);
    };
    low = inRange(low);
    high = inRange(high);
  };
  widen(box.xmin, box.xmax);
  widen(box.ymin, box.ymax);
  return areGood(box) ? box : Bounds{};
}

double defaultTolerance(const Bounds& bounds) {
  return kDefaultShare * windowOf(bounds).diagonal();
}

std::uint32_t Voronoi::slotOf(SiteId id) const { return diagram_.core_->ids().slotOf(id); }

template <class Operation>
Error Voronoi::guarded(double tolerance, Operation&& operation) const {
  if (region_ != nullptr ? region_->state_ == nullptr : !areGood(bounds_)) return Error::kBadBounds;
  if (!std::isfinite(tolerance)) return Error::kNotFinite;
  if (!(tolerance > 0)) return Error::kOutOfRange;
  return internal::guarded(*diagram_.core_, [&] { operation(windowOf(bounds_), tolerance); });
}

template <class Operation>
Error Voronoi::guardedFor(SiteId id, double tolerance, Operation&& operation) const {
  if (region_ != nullptr ? region_->state_ == nullptr : !areGood(bounds_)) return Error::kBadBounds;
  if (!diagram_.has(id)) return Error::kUnknownSite;
  return guarded(tolerance, operation);
}

template <class Visit>
void Voronoi::withCell(SiteId id, Visit&& visit) const {
  const DiagramCore& core = *diagram_.core_;
  const Slot slot = slotOf(id);
  const Point center{core.site(slot).x, core.site(slot).y};
  if (region_ == nullptr) {
    RectangleCellClipper finder(core, windowOf(bounds_));
    visit(finder.find(slot), center);
  } else {
    PolygonCellClipper finder(clippedDiagram());
    visit(finder.find(slot), center);
  }
}

const ClippedDiagram& Voronoi::clippedDiagram() const {
  return region_->state_->clippedOn(*diagram_.core_, diagram_.state_);
}

Error Voronoi::edgeCurves(CurveArrays& edges) const {
  return guarded(1, [&](const Rectangle& window, double) {
    edges = {};
    const DiagramCore& core = *diagram_.core_;
    const Graph& graph = core.delaunay().graph();
    const auto add = [&](HalfedgeId h, const Conic& curve) {
      appendCurve(curve, edges.curves);
      edges.sites.push_back(core.siteOf(graph.origin(h)));
      edges.sites.push_back(core.siteOf(graph.target(h)));
    };
    if (region_ == nullptr) {
      forEachClippedPiece(core.delaunay(), window, VertexPrecision::kReproducible,
                          [&](HalfedgeId h, const ClippedPiece& piece) { add(h, piece.curve); });
    } else {
      clippedDiagram().visitEdges(
          VertexPrecision::kReproducible,
          [&](HalfedgeId h, const Edge&, const InsideInterval& piece) { add(h, piece.curve); });
    }
  });
}

Error Voronoi::cellCurves(SiteId id, CurveArrays& boundary) const {
  return guardedFor(id, 1, [&](const Rectangle&, double) {
    withCell(id, [&](const Cell& cell, Point) {
      boundary.curves.clear();
      boundary.sites.clear();
      for (const BoundaryPiece& piece : cell.pieces) {
        appendCurve(piece.curve, boundary.curves);
        boundary.sites.push_back(piece.neighbor);
      }
      boundary.starts.assign(cell.starts.begin(), cell.starts.end());
    });
  });
}

PolygonWindow Voronoi::polygonWindow() const {
  if (region_ == nullptr) return {windowOf(bounds_)};
  return {windowOf(bounds_), &clippedDiagram(), &region_->state_->polygonGrid()};
}

Error Voronoi::cellPolygon(SiteId id, double tolerance, RingArrays& rings) const {
  return guardedFor(id, tolerance, [&](const Rectangle&, double allowed) {
    Rings found;
    PolygonFinder(*diagram_.core_, polygonWindow(), allowed).find(slotOf(id), found);
    assign(rings, found);
  });
}

Error Voronoi::cellPolygons(double tolerance, CoverageArrays& coverage) const {
  return guarded(tolerance, [&](const Rectangle&, double allowed) {
    Coverage found;
    coverWindow(*diagram_.core_, polygonWindow(), allowed, found);
    assign(coverage, found.rings);
    coverage.sites.assign(found.sites.begin(), found.sites.end());
    coverage.cells.assign(found.cells.begin(), found.cells.end());
  });
}

Error Voronoi::cellMeasures(SiteId id, CellMeasures& measures) const {
  return guardedFor(id, 1, [&](const Rectangle& window, double) {
    measures = {};
    withCell(id, [&](const Cell& cell, Point center) {
      const Point origin = window.nearestTo(center);
      Moments moments;
      addUp(cell.pieces, origin, moments, measures);
      finish(moments, origin, measures);
    });
  });
}

Error Voronoi::cellMeasuresWithin(SiteId id, double radius, CellMeasures& measures) const {
  if (!diagram_.has(id)) return Error::kUnknownSite;
  const bool isUnlimited = radius == std::numeric_limits<double>::infinity();
  if (!std::isfinite(radius) && !isUnlimited) return Error::kNotFinite;
  if (radius < 0 || (radius > kLargestMagnitude && !isUnlimited)) return Error::kOutOfRange;
  const Voronoi anywhere(diagram_);
  return anywhere.guarded(1, [&](const Rectangle&, double) {
    FlatArray<BoundaryPiece> boundary;
    cellWithin(*diagram_.core_, slotOf(id), std::min(radius, kLargestMagnitude), boundary);
    measures = {};
    const auto isArc = [](const BoundaryPiece& piece) { return piece.neighbor == kNoSite; };
    if (isUnlimited && std::any_of(boundary.begin(), boundary.end(), isArc)) {
      measures.area = measures.perimeter = radius;
      measures.isEmpty = true;  // without a centroid
      return;
    }
    const Site& site = diagram_.core_->site(slotOf(id));
    Moments moments;
    addUp(boundary, {site.x, site.y}, moments, measures);
    finish(moments, {site.x, site.y}, measures);
  });
}

Error Voronoi::measureAll(internal::Measure what, std::vector<double>& measures) const {
  return guarded(1, [&](const Rectangle& window, double) {
    if (region_ == nullptr) {
      measureCells(*diagram_.core_, window, what, measures);
    } else {
      measureCells(clippedDiagram(), what, measures);
    }
  });
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

Error Voronoi::hull(std::vector<SiteId>& sites) const {
  return guarded(1, [&](const Rectangle&, double) { hullSites(*diagram_.core_, sites); });
}

Error Voronoi::drawEdges(double tolerance, Portion& portion, Path& path) const {
  return guarded(tolerance, [&](const Rectangle& window, double allowed) {
    path.clear();
    if (region_ == nullptr) {
      internal::drawEdges(*diagram_.core_, window, allowed, portion, path);
    } else {
      internal::drawEdges(clippedDiagram(), allowed, portion, path);
    }
  });
}

Error Voronoi::drawSites(double tolerance, Portion& portion, Path& path) const {
  return guarded(tolerance, [&](const Rectangle&, double allowed) {
    path.clear();
    internal::drawSites(*diagram_.core_, allowed, portion, path);
  });
}

Error Voronoi::drawDual(double tolerance, bool rays, Portion& portion, Path& path) const {
  return guarded(tolerance, [&](const Rectangle& window, double allowed) {
    path.clear();
    internal::drawDual(*diagram_.core_, rays ? &window : nullptr, allowed, portion, path);
  });
}

Error Voronoi::drawCell(SiteId id, double tolerance, Path& path) const {
  return guardedFor(id, tolerance, [&](const Rectangle&, double allowed) {
    path.clear();
    withCell(id, [&](const Cell& cell, Point) {
      for (std::size_t ring = 0; ring < cell.ringCount(); ++ring)
        drawClosed(cell.ring(ring), allowed, path);
    });
  });
}

Error Voronoi::drawHull(double tolerance, Path& path) const {
  return guarded(tolerance, [&](const Rectangle&, double allowed) {
    path.clear();
    internal::drawHull(*diagram_.core_, allowed, path);
  });
}

}  // namespace apollonius
