// The geometry's door: checks bounds, ids and tolerances, turns lack of memory into an error, and
// leaves the work to src/geometry.
#include "apollonius/voronoi.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "api/checks.h"
#include "geometry/approximate.h"
#include "geometry/areas.h"
#include "geometry/cell.h"
#include "geometry/hull.h"
#include "geometry/measures.h"
#include "geometry/render.h"
#include "geometry/ring.h"
#include "geometry/within.h"
#include "memory/flat_array.h"

namespace apollonius {

using namespace internal;

namespace {

Window windowOf(const Bounds& b) { return {b.xmin, b.ymin, b.xmax, b.ymax}; }

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

void measure(std::span<const BoundaryPiece> boundary, Point origin, Moments& moments,
             CellMeasures& measures) {
  for (const BoundaryPiece& piece : boundary) {
    moments.add(piece.curve, origin);
    measures.perimeter += lengthOf(piece.curve);
  }
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
  if (!areGood(bounds_)) return Error::kBadBounds;
  if (!std::isfinite(tolerance)) return Error::kNotFinite;
  if (!(tolerance > 0)) return Error::kOutOfRange;
  return internal::guarded(*diagram_.core_, [&] { operation(windowOf(bounds_), tolerance); });
}

template <class Operation>
Error Voronoi::guardedFor(SiteId id, double tolerance, Operation&& operation) const {
  if (!areGood(bounds_)) return Error::kBadBounds;
  if (!diagram_.has(id)) return Error::kUnknownSite;
  return guarded(tolerance, operation);
}

Error Voronoi::edgeCurves(CurveArrays& edges) const {
  return guarded(1, [&](const Window& window, double) {
    edges = {};
    const DiagramCore& core = *diagram_.core_;
    const Graph& graph = core.delaunay().graph();
    forEachClippedPiece(core.delaunay(), window, Bits::kCanonical,
                        [&](HalfedgeId h, const ClippedPiece& piece) {
                          appendCurve(piece.curve, edges.curves);
                          edges.sites.push_back(core.siteOf(graph.origin(h)));
                          edges.sites.push_back(core.siteOf(graph.target(h)));
                        });
  });
}

Error Voronoi::cellCurves(SiteId id, CurveArrays& boundary) const {
  return guardedFor(id, 1, [&](const Window& window, double) {
    CellFinder finder(*diagram_.core_, window);
    const Cell& cell = finder.find(slotOf(id));
    boundary.curves.clear();
    boundary.sites.clear();
    for (const BoundaryPiece& piece : cell.pieces) {
      appendCurve(piece.curve, boundary.curves);
      boundary.sites.push_back(piece.neighbor);
    }
    boundary.regions.clear();
    for (const std::uint32_t start : cell.starts) boundary.regions.push_back(start);
  });
}

Error Voronoi::cellPolygon(SiteId id, double tolerance, RingArrays& rings) const {
  return guardedFor(id, tolerance, [&](const Window& window, double allowed) {
    CellFinder finder(*diagram_.core_, window);
    const Cell& cell = finder.find(slotOf(id));
    const Site& site = diagram_.core_->site(slotOf(id));
    rings.coordinates.clear();
    rings.starts.assign(1, 0);
    for (std::size_t region = 0; region < cell.regionCount(); ++region) {
      const std::uint32_t first = cell.starts[region], count = cell.starts[region + 1] - first;
      const std::size_t size = rings.coordinates.size();
      appendRing(std::span(cell.pieces).subspan(first, count), {site.x, site.y}, window, allowed,
                 rings.coordinates);
      if (rings.coordinates.size() == size) continue;
      rings.starts.push_back(static_cast<std::uint32_t>(rings.coordinates.size() / 2));
    }
  });
}

Error Voronoi::cellMeasures(SiteId id, CellMeasures& measures) const {
  return guardedFor(id, 1, [&](const Window& window, double) {
    CellFinder finder(*diagram_.core_, window);
    const Cell& cell = finder.find(slotOf(id));
    measures = {};
    const Site& site = diagram_.core_->site(slotOf(id));
    const Point origin = window.nearestTo({site.x, site.y});
    Moments moments;
    measure(cell.pieces, origin, moments, measures);
    finish(moments, origin, measures);
  });
}

Error Voronoi::cellMeasuresWithin(SiteId id, double radius, CellMeasures& measures) const {
  if (!diagram_.has(id)) return Error::kUnknownSite;
  if (!std::isfinite(radius)) return Error::kNotFinite;
  if (radius < 0 || radius > kLargestMagnitude) return Error::kOutOfRange;
  const Voronoi anywhere(diagram_);
  return anywhere.guarded(1, [&](const Window&, double) {
    FlatArray<BoundaryPiece> boundary;
    cellWithin(*diagram_.core_, slotOf(id), radius, boundary);
    measures = {};
    const Site& site = diagram_.core_->site(slotOf(id));
    Moments moments;
    measure(boundary, {site.x, site.y}, moments, measures);
    finish(moments, {site.x, site.y}, measures);
  });
}

Error Voronoi::cellAreas(std::vector<double>& areas) const {
  return guarded(1, [&](const Window& window, double) {
    internal::cellAreas(*diagram_.core_, window, areas);
  });
}

Error Voronoi::hull(std::vector<SiteId>& sites) const {
  return guarded(1, [&](const Window&, double) { hullSites(*diagram_.core_, sites); });
}

Error Voronoi::drawEdges(double tolerance, Portion& portion, Path& path) const {
  return guarded(tolerance, [&](const Window& window, double allowed) {
    path.clear();
    internal::drawEdges(*diagram_.core_, window, allowed, portion, path);
  });
}

Error Voronoi::drawSites(double tolerance, Portion& portion, Path& path) const {
  return guarded(tolerance, [&](const Window&, double allowed) {
    path.clear();
    internal::drawSites(*diagram_.core_, allowed, portion, path);
  });
}

Error Voronoi::drawDual(double tolerance, bool rays, Portion& portion, Path& path) const {
  return guarded(tolerance, [&](const Window& window, double allowed) {
    path.clear();
    internal::drawDual(*diagram_.core_, rays ? &window : nullptr, allowed, portion, path);
  });
}

Error Voronoi::drawCell(SiteId id, double tolerance, Path& path) const {
  return guardedFor(id, tolerance, [&](const Window& window, double allowed) {
    path.clear();
    CellFinder finder(*diagram_.core_, window);
    const Cell& cell = finder.find(slotOf(id));
    for (std::size_t region = 0; region < cell.regionCount(); ++region) {
      const std::uint32_t end = cell.starts[region + 1];
      const Point start = cell.pieces[cell.starts[region]].curve.p0;
      path.move(start.x, start.y);
      for (std::uint32_t k = cell.starts[region]; k < end; ++k) {
        const Conic& curve = cell.pieces[k].curve;
        const bool isClosing = k + 1 == end && curve.isStraight();  // close() draws it
        if (!isClosing && !(curve.p0 == curve.p2)) drawConic(curve, allowed, path);
      }
      path.close();
    }
  });
}

Error Voronoi::drawHull(double tolerance, Path& path) const {
  return guarded(tolerance, [&](const Window&, double allowed) {
    path.clear();
    internal::drawHull(*diagram_.core_, allowed, path);
  });
}

}  // namespace apollonius
