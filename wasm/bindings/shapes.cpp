// The part `shapes` for Embind: the cells of a diagram in a window, drawings, fits. Its calls are
// functions of the diagram; wasm/package/shapes makes methods of them.
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "adapters.h"
#include "apollonius/area_fit.h"
#include "apollonius/diagram.h"
#include "apollonius/voronoi.h"
#include "parts.h"

using apollonius::AreaFit;
using apollonius::Bounds;
using apollonius::Diagram;
using apollonius::Reach;
using apollonius::Region;
using apollonius::Voronoi;

namespace {

/// Returns the cells in a region, or in bounds if `region` is null; `reach` may be null.
Voronoi voronoiIn(const Diagram& diagram, const Region* region, const Reach* reach,
                  const Bounds& bounds) {
  return region == nullptr ? Voronoi(diagram, bounds, reach) : Voronoi(diagram, *region, reach);
}

/// A method of Voronoi, `Error method(in..., Out& out) const`, as a function of the diagram, the
/// window and `in` that returns `out`.
template <auto method, class... Parameters, std::size_t... k>
auto inWindow(Error (Voronoi::*)(Parameters...) const, std::index_sequence<k...>) {
  return +[](const Diagram& diagram, const Region* region, const Reach* reach, double xmin,
             double ymin, double xmax, double ymax, Nth<k, Parameters...>... in) {
    std::remove_reference_t<Nth<sizeof...(k), Parameters...>> out{};
    check((voronoiIn(diagram, region, reach, {xmin, ymin, xmax, ymax}).*method)(in..., out));
    return out;
  };
}
template <auto method>
auto inWindow() {
  return inWindow<method>(method, inputsOf(method));
}

/// Values by id at points x, y, ….
std::vector<double> interpolate(const Diagram& diagram, const Region* region, const Reach* reach,
                                double xmin, double ymin, double xmax, double ymax,
                                const NumbersIn& values, const NumbersIn& xy, double r) {
  const std::vector<double> points = vectorOf<double>(xy);
  auto results = allocating([&] { return std::vector<double>(points.size() / 2); });
  check(voronoiIn(diagram, region, reach, {xmin, ymin, xmax, ymax})
            .interpolate(vectorOf<double>(values), points, r, results));
  return results;
}

/// `groups` by id, or nothing for the polygon of each cell.
apollonius::CoverageArrays cellPolygons(const Diagram& diagram, const Region* region,
                                        const Reach* reach, double xmin, double ymin, double xmax,
                                        double ymax, double tolerance, const NumbersIn& groups) {
  apollonius::CoverageArrays polygons;
  check(voronoiIn(diagram, region, reach, {xmin, ymin, xmax, ymax})
            .cellPolygons(tolerance, polygons, vectorOf<std::uint32_t>(groups)));
  return polygons;
}

// --- Drawings

enum class Drawing : std::uint8_t { kEdges, kSites, kDual, kDualWithRays, kHull };

/// A part of a drawing. `cursor` is where the next part begins. For cells, `ends` holds each cell's
/// site and where its commands end.
struct Portion {
  std::vector<std::uint8_t> commands;
  std::vector<double> coordinates;
  std::vector<double> ends{};
  std::size_t cursor = 0;
  bool isDone = true;
};

/// Returns about this many commands of a drawing, from the cursor on.
Portion draw(const Diagram& diagram, const Region* region, const Reach* reach, double xmin,
             double ymin, double xmax, double ymax, Drawing what, double tolerance,
             std::size_t cursor, std::size_t commands) {
  const Voronoi voronoi = voronoiIn(diagram, region, reach, {xmin, ymin, xmax, ymax});
  apollonius::Portion portion{cursor, commands};
  apollonius::Path path;
  allocating([&] {
    // The last edge may exceed that number. Most edges are segments: two commands and two points.
    const std::size_t room = commands + commands / 4;
    path.commands.reserve(room);
    path.coordinates.reserve(3 * room);
  });
  const auto drawn = [&] {
    switch (what) {
      case Drawing::kEdges:
        return voronoi.drawEdges(tolerance, portion, path);
      case Drawing::kSites:
        return voronoi.drawSites(tolerance, portion, path);
      case Drawing::kDual:
        return voronoi.drawDual(tolerance, false, portion, path);
      case Drawing::kDualWithRays:
        return voronoi.drawDual(tolerance, true, portion, path);
      case Drawing::kHull:
        break;
    }
    portion.isDone = true;
    return voronoi.drawHull(tolerance, path);
  };
  check(drawn());
  return {
      std::move(path.commands), std::move(path.coordinates), {}, portion.cursor, portion.isDone};
}

Portion drawCell(const Diagram& diagram, const Region* region, const Reach* reach, double xmin,
                 double ymin, double xmax, double ymax, SiteId id, double tolerance) {
  apollonius::Path path;
  check(voronoiIn(diagram, region, reach, {xmin, ymin, xmax, ymax}).drawCell(id, tolerance, path));
  return {std::move(path.commands), std::move(path.coordinates)};
}

/// Returns about this many commands of all cells, from the cursor on.
Portion drawCells(const Diagram& diagram, const Region* region, const Reach* reach, double xmin,
                  double ymin, double xmax, double ymax, double tolerance, std::size_t cursor,
                  std::size_t commands) {
  apollonius::CellDrawings cells;
  apollonius::Portion portion{cursor, commands};
  check(voronoiIn(diagram, region, reach, {xmin, ymin, xmax, ymax})
            .drawCells(tolerance, portion, cells));
  return {std::move(cells.content.commands), std::move(cells.content.coordinates),
          std::move(cells.ends), portion.cursor, portion.isDone};
}

/// Returns a part of all cells as SVG path data: `commands` is the text. If it is not done and has
/// no cell, some number has too many digits.
Portion cellPaths(const Diagram& diagram, const Region* region, const Reach* reach, double xmin,
                  double ymin, double xmax, double ymax, double tolerance, unsigned digits,
                  std::size_t cursor, std::size_t commands) {
  apollonius::CellPaths paths;
  apollonius::Portion portion{cursor, commands};
  check(voronoiIn(diagram, region, reach, {xmin, ymin, xmax, ymax})
            .cellPaths(tolerance, digits, portion, paths));
  return {std::move(paths.content), {}, std::move(paths.ends), portion.cursor, portion.isDone};
}

/// Makes a region for windows on diagrams of this instance of the module.
Region* makeRegion(const Diagram&, const NumbersIn& coordinates, const NumbersIn& starts) {
  Region region;
  check(region.assign(vectorOf<double>(coordinates), vectorOf<std::uint32_t>(starts)));
  return allocating([&] { return new Region(std::move(region)); });
}

/// Makes a reach of one distance for each of `ids`, which ascend. Without `ids`, `distances` has
/// one number for all sites, or one for each id.
Reach* makeReach(const Diagram&, const NumbersIn& distances, const NumbersIn& ids) {
  const std::vector<double> values = vectorOf<double>(distances);
  const std::vector<SiteId> sites = vectorOf<SiteId>(ids);
  auto reach = allocating([&] {
    return !sites.empty()       ? std::make_unique<Reach>(sites, values)
           : values.size() != 1 ? std::make_unique<Reach>(std::span<const double>(values))
                                : std::make_unique<Reach>(values[0]);
  });
  if (reach->hasNaN()) check(Error::kNotFinite);
  if (reach->isOutOfRange()) check(Error::kOutOfRange);
  return reach.release();
}

Portion drawRegion(const Diagram&, const Region& region) {
  apollonius::Path path;
  check(region.draw(path));
  return {std::move(path.commands), std::move(path.coordinates)};
}

apollonius::Circle innerCircle(const Diagram&, const NumbersIn& curves, const NumbersIn& starts,
                               double aspect) {
  apollonius::Circle circle{};
  check(apollonius::innerCircle(vectorOf<double>(curves), vectorOf<std::uint32_t>(starts), aspect,
                                circle));
  return circle;
}

double defaultTolerance(const Diagram&, double xmin, double ymin, double xmax, double ymax) {
  return apollonius::defaultTolerance({xmin, ymin, xmax, ymax});
}

/// A fit of areas. `box` is its region if the window is bounds.
struct Fitting {
  Region box;
  AreaFit fit;
};

/// Begins a fit, which the caller deletes. If a target is bad, badSite() gives its site.
Fitting* fitAreas(const Diagram& diagram, const Region* region, const Reach* /*reach*/, double xmin,
                  double ymin, double xmax, double ymax, const NumbersIn& targets,
                  const NumbersIn& start) {
  auto fitting = allocating([&] { return std::make_unique<Fitting>(); });
  if (region == nullptr) {
    const double ring[] = {xmin, ymin, xmax, ymin, xmax, ymax, xmin, ymax};
    const std::uint32_t starts[] = {0, 4};
    check(fitting->box.assign(ring, starts));
    region = &fitting->box;
  }
  const Error error =
      fitting->fit.begin(diagram, *region, vectorOf<double>(targets), vectorOf<double>(start));
  if (error != Error::kBadTarget) check(error);
  return fitting.release();
}
/// Does a step and returns the error after it.
double stepFit(Fitting& fitting) {
  check(fitting.fit.step());
  return fitting.fit.error();
}
bool isAtTheEndOfDoubles(const Fitting& fitting) { return fitting.fit.isAtTheEndOfDoubles(); }
double fitError(const Fitting& fitting) { return fitting.fit.error(); }
std::int32_t badSite(const Fitting& fitting) { return asSigned(fitting.fit.badSite()); }
std::vector<double> fitWeights(const Fitting& fitting) {
  std::vector<double> weights;
  check(fitting.fit.weights(weights));
  return weights;
}
void finishFit(Diagram& diagram, const Fitting& fitting) { check(fitting.fit.finish(diagram)); }

}  // namespace

void registerShapes() {
  using namespace emscripten;
  const return_value_policy::take_ownership moved;  // not copied

  enum_<Drawing>("Drawing")
      .value("edges", Drawing::kEdges)
      .value("sites", Drawing::kSites)
      .value("dual", Drawing::kDual)
      .value("dualWithRays", Drawing::kDualWithRays)
      .value("hull", Drawing::kHull);

  value_object<Bounds>("Bounds")
      .field("xmin", &Bounds::xmin)
      .field("ymin", &Bounds::ymin)
      .field("xmax", &Bounds::xmax)
      .field("ymax", &Bounds::ymax);
  value_object<apollonius::CurveArrays>("CurveArrays")
      .field("curves", &apollonius::CurveArrays::curves)
      .field("sites", &apollonius::CurveArrays::sites)
      .field("starts", &apollonius::CurveArrays::starts);
  value_object<apollonius::EdgeGraph>("EdgeGraph")
      .field("vertices", &apollonius::EdgeGraph::vertices)
      .field("edges", &apollonius::EdgeGraph::edges)
      .field("narrowest", &apollonius::EdgeGraph::narrowest);
  value_object<apollonius::CellMoments>("CellMoments")
      .field("area", &apollonius::CellMoments::area)
      .field("centroidX", &apollonius::CellMoments::centroidX)
      .field("centroidY", &apollonius::CellMoments::centroidY)
      .field("isEmpty", &apollonius::CellMoments::isEmpty);
  value_object<apollonius::CellMeasures>("CellMeasures")
      .field("area", &apollonius::CellMeasures::area)
      .field("centroidX", &apollonius::CellMeasures::centroidX)
      .field("centroidY", &apollonius::CellMeasures::centroidY)
      .field("perimeter", &apollonius::CellMeasures::perimeter)
      .field("isEmpty", &apollonius::CellMeasures::isEmpty);
  value_object<apollonius::NaturalWeights>("NaturalWeights")
      .field("ids", &apollonius::NaturalWeights::ids)
      .field("weights", &apollonius::NaturalWeights::weights);
  value_object<apollonius::EnclosingCircle>("EnclosingCircle")
      .field("x", &apollonius::EnclosingCircle::x)
      .field("y", &apollonius::EnclosingCircle::y)
      .field("r", &apollonius::EnclosingCircle::r)
      .field("sites", &apollonius::EnclosingCircle::sites);
  value_object<Portion>("Portion")
      .field("commands", &Portion::commands)
      .field("coordinates", &Portion::coordinates)
      .field("ends", &Portion::ends)
      .field("cursor", &Portion::cursor)
      .field("isDone", &Portion::isDone);

  class_<Region>("Region")
      .function("box", &Region::box)
      .function("area", &Region::area)
      .function("centroidX", &Region::centroidX)
      .function("centroidY", &Region::centroidY)
      .function("contains", &Region::contains);
  class_<Reach>("Reach");
  class_<Fitting>("Fitting")
      .function("step", &stepFit)
      .function("isAtTheEndOfDoubles", &isAtTheEndOfDoubles)
      .function("error", &fitError)
      .function("badSite", &badSite)
      .function("weights", &fitWeights);

  function("cellCircle", inWindow<&Voronoi::cellCircle>(), allow_raw_pointers());
  function("cellCirclesBetween", inWindow<&Voronoi::cellCirclesBetween>(), allow_raw_pointers());
  function("emptyCircles", inWindow<&Voronoi::emptyCircles>(), allow_raw_pointers(), moved);
  function("innerCircle", &innerCircle);
  function("naturalWeights", inWindow<&Voronoi::naturalWeights>(), allow_raw_pointers());
  function("interpolate", &interpolate, allow_raw_pointers());
  function("defaultTolerance", &defaultTolerance);
  function("extent", &Voronoi::extentOf);
  function("enclosingCircle", returning<&Diagram::enclosingCircle>());
  function("region", &makeRegion, allow_raw_pointers(), moved);
  function("reach", &makeReach, allow_raw_pointers(), moved);
  function("drawRegion", &drawRegion, moved);
  function("fitAreas", &fitAreas, allow_raw_pointers(), moved);
  function("finishFit", &finishFit);
  function("draw", &draw, allow_raw_pointers(), moved);
  function("drawCell", &drawCell, allow_raw_pointers(), moved);
  function("drawCells", &drawCells, allow_raw_pointers(), moved);
  function("cellPaths", &cellPaths, allow_raw_pointers(), moved);
  function("cellPolygon", inWindow<&Voronoi::cellPolygon>(), allow_raw_pointers(), moved);
  function("cellPolygons", &cellPolygons, allow_raw_pointers(), moved);
  function("cellPolygonsBetween", inWindow<&Voronoi::cellPolygonsBetween>(), allow_raw_pointers(),
           moved);
  function("cellCurves", inWindow<&Voronoi::cellCurves>(), allow_raw_pointers(), moved);
  function("edgeCurves", inWindow<&Voronoi::edgeCurves>(), allow_raw_pointers(), moved);
  function("edgeGraph", inWindow<&Voronoi::edgeGraph>(), allow_raw_pointers(), moved);
  function("narrowest", returning<&Diagram::narrowest>(), moved);
  function("cellNeighbors", inWindow<&Voronoi::neighbors>(), allow_raw_pointers());
  function("cellMoments", inWindow<&Voronoi::cellMoments>(), allow_raw_pointers());
  function("cellMeasures", inWindow<&Voronoi::cellMeasures>(), allow_raw_pointers());
  function("cellAreas", inWindow<&Voronoi::cellAreas>(), allow_raw_pointers());
  function("cellCentroids", inWindow<&Voronoi::cellCentroids>(), allow_raw_pointers());
  function("cellPerimeters", inWindow<&Voronoi::cellPerimeters>(), allow_raw_pointers());
}
