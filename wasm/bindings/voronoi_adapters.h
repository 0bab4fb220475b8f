// Calls of Voronoi, regions, drawings and fits, adapted as adapters.h says.
#pragma once

#include "adapters.h"

namespace {

// --- Drawings

enum class Drawing : std::uint8_t { kEdges, kSites, kDual, kDualWithRays, kHull };

/// A part of a drawing, and where the next one begins.
struct Portion {
  std::vector<std::uint8_t> commands;
  std::vector<double> coordinates;
  std::size_t cursor = 0;
  bool isDone = true;
};

/// About this many commands of a drawing, from the cursor on.
Portion draw(const Diagram& diagram, const Region* region, const Reach* reach, double xmin,
             double ymin, double xmax, double ymax, Drawing what, double tolerance,
             std::size_t cursor, std::size_t commands) {
  const Voronoi voronoi = voronoiIn(diagram, region, reach, {xmin, ymin, xmax, ymax});
  apollonius::Portion portion{cursor, commands};
  apollonius::Path path;
  allocating([&] {
    // The last edges go beyond that number. Most are segments, of two commands and two points.
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
  return {std::move(path.commands), std::move(path.coordinates), portion.cursor, portion.isDone};
}

Portion drawCell(const Diagram& diagram, const Region* region, const Reach* reach, double xmin,
                 double ymin, double xmax, double ymax, SiteId id, double tolerance) {
  apollonius::Path path;
  check(voronoiIn(diagram, region, reach, {xmin, ymin, xmax, ymax}).drawCell(id, tolerance, path));
  return {std::move(path.commands), std::move(path.coordinates)};
}

/// About this many commands of cells as SVG path data: `commands` is the text, and `coordinates`
/// has each cell's site and where its text ends. Not done and without a cell: some number has too
/// many digits.
Portion cellPaths(const Diagram& diagram, const Region* region, const Reach* reach, double xmin,
                  double ymin, double xmax, double ymax, double tolerance, unsigned digits,
                  std::size_t cursor, std::size_t commands) {
  apollonius::CellPaths paths;
  apollonius::Portion portion{cursor, commands};
  check(voronoiIn(diagram, region, reach, {xmin, ymin, xmax, ymax})
            .cellPaths(tolerance, digits, portion, paths));
  return {std::move(paths.text), std::move(paths.ends), portion.cursor, portion.isDone};
}

/// A region for windows on diagrams of this instance of the module.
Region* makeRegion(const Diagram&, const NumbersIn& coordinates, const NumbersIn& starts) {
  Region region;
  check(region.assign(vectorOf<double>(coordinates), vectorOf<std::uint32_t>(starts)));
  return allocating([&] { return new Region(std::move(region)); });
}

/// One distance for all sites, or one for each id.
Reach* makeReach(const Diagram&, const NumbersIn& distances, bool isById) {
  const std::vector<double> values = vectorOf<double>(distances);
  auto reach = allocating([&] {
    return isById ? std::make_unique<Reach>(std::span<const double>(values))
                  : std::make_unique<Reach>(values.at(0));
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

double defaultTolerance(const Diagram&, double xmin, double ymin, double xmax, double ymax) {
  return apollonius::defaultTolerance({xmin, ymin, xmax, ymax});
}

/// With the region, where that is made for bounds.
struct Fitting {
  Region box;
  AreaFit fit;
};

/// The caller deletes it. If a target is bad, it has the site.
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
void stepFit(Fitting& fitting) { check(fitting.fit.step()); }
bool isAtTheEndOfDoubles(const Fitting& fitting) { return fitting.fit.isAtTheEndOfDoubles(); }
double fitError(const Fitting& fitting) { return fitting.fit.error(); }
std::int32_t badSite(const Fitting& fitting) { return asSigned(fitting.fit.badSite()); }
std::vector<double> fitWeights(const Fitting& fitting) {
  std::vector<double> weights;
  check(fitting.fit.weights(weights));
  return weights;
}
void finishFit(Diagram& diagram, const Fitting& fitting) { check(fitting.fit.finish(diagram)); }

apollonius::CellMeasures measuresWithin(const Diagram& diagram, SiteId id, double radius) {
  apollonius::CellMeasures measures;
  check(Voronoi(diagram).cellMeasuresWithin(id, radius, measures));
  return measures;
}

std::vector<SiteId> hull(const Diagram& diagram) {
  std::vector<SiteId> sites;
  check(Voronoi(diagram).hull(sites));
  return sites;
}

}  // namespace
