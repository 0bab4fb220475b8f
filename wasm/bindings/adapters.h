// The functions that adapt the library to Embind, for bindings.cpp: results are returned, errors
// thrown (arrays.h), records come in as numbers one by one, because Embind would leak one if the
// call throws.
#pragma once

#include <emscripten/bind.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "apollonius/area_fit.h"
#include "apollonius/builder.h"
#include "apollonius/diagram.h"
#include "apollonius/nearest_first.h"
#include "apollonius/predicate_counts.h"
#include "apollonius/voronoi.h"
#include "arrays.h"

using apollonius::AreaFit;
using apollonius::Bounds;
using apollonius::Builder;
using apollonius::Circle;
using apollonius::Diagram;
using apollonius::Error;
using apollonius::Location;
using apollonius::NearestFirst;
using apollonius::Reach;
using apollonius::Region;
using apollonius::SiteId;
using apollonius::Source;
using apollonius::Top;
using apollonius::Voronoi;
using emscripten::val;

namespace {

// --- Calls. `AnyDiagram` is a Diagram or a SphericalDiagram.

template <std::size_t k, class... Types>
using Nth = std::tuple_element_t<k, std::tuple<Types...>>;

/// -1 for kNoSite.
std::int32_t asSigned(SiteId id) { return static_cast<std::int32_t>(id); }

/// `Error method(in..., Out& out)` of a class as a function of the object and `in` that returns
/// `out`, an id as asSigned() does.
template <auto method, class Class, class... Parameters, std::size_t... k>
auto returning(Error (Class::*)(Parameters...), std::index_sequence<k...>) {
  return +[](Class& object, Nth<k, Parameters...>... in) {
    std::remove_reference_t<Nth<sizeof...(k), Parameters...>> out{};
    check((object.*method)(in..., out));
    if constexpr (std::is_same_v<decltype(out), SiteId>) {
      return asSigned(out);
    } else {
      return out;
    }
  };
}
template <auto method, class Class, class... Parameters, std::size_t... k>
auto returning(Error (Class::*)(Parameters...) const, std::index_sequence<k...>) {
  return +[](const Class& object, Nth<k, Parameters...>... in) {
    std::remove_reference_t<Nth<sizeof...(k), Parameters...>> out{};
    check((object.*method)(in..., out));
    if constexpr (std::is_same_v<decltype(out), SiteId>) {
      return asSigned(out);
    } else {
      return out;
    }
  };
}
/// The cells in a region, or in bounds if `region` is null; within a reach, if there is one.
Voronoi voronoiIn(const Diagram& diagram, const Region* region, const Reach* reach,
                  const Bounds& bounds) {
  return region == nullptr ? Voronoi(diagram, bounds, reach) : Voronoi(diagram, *region, reach);
}

/// Overload for methods of Voronoi: a function of the diagram and the window.
template <auto method, class... Parameters, std::size_t... k>
auto returning(Error (Voronoi::*)(Parameters...) const, std::index_sequence<k...>) {
  return +[](const Diagram& diagram, const Region* region, const Reach* reach, double xmin,
             double ymin, double xmax, double ymax, Nth<k, Parameters...>... in) {
    std::remove_reference_t<Nth<sizeof...(k), Parameters...>> out{};
    check((voronoiIn(diagram, region, reach, {xmin, ymin, xmax, ymax}).*method)(in..., out));
    return out;
  };
}
template <class Class, class... Parameters>
constexpr auto inputsOf(Error (Class::*)(Parameters...)) {
  return std::make_index_sequence<sizeof...(Parameters) - 1>();
}
template <class Class, class... Parameters>
constexpr auto inputsOf(Error (Class::*)(Parameters...) const) {
  return std::make_index_sequence<sizeof...(Parameters) - 1>();
}
template <auto method>
auto returning() {
  return returning<method>(method, inputsOf(method));
}

Diagram* create(Location location) {
  return allocating([&] { return new Diagram(location); });
}

struct Nearest {
  std::int32_t id = -1;
  double distance = 0;
};
template <class AnyDiagram>
Nearest nearest(const AnyDiagram& diagram, double x, double y) {
  SiteId id = apollonius::kNoSite;
  double distance = 0;
  check(diagram.find(x, y, id, distance));
  return {asSigned(id), distance};
}
template <class AnyDiagram>
std::int32_t find(const AnyDiagram& diagram, double x, double y) {
  SiteId id = apollonius::kNoSite;
  check(diagram.find(x, y, id));
  return asSigned(id);
}

/// The caller deletes it, before the diagram changes.
template <class Walk, class AnyDiagram>
Walk* nearestFirst(const AnyDiagram& diagram, double x, double y, double farthest) {
  auto walk = allocating([&] { return std::make_unique<Walk>(diagram); });
  check(walk->start(x, y, farthest));
  return walk.release();
}

template <class AnyDiagram>
void update(AnyDiagram& diagram, SiteId id, double x, double y, double r) {
  check(diagram.update(id, x, y, r));
}

/// The new ids go to an array that is there before, so that nothing can fail when all are in.
void insertMany(Diagram& diagram, const NumbersIn& xyr, const NumbersOut& ids) {
  std::vector<SiteId> inserted;
  check(diagram.insertMany(vectorOf<double>(xyr), inserted));
  ids.call<void>("set", viewOf(inserted));
}

template <class AnyDiagram>
std::size_t removeMany(AnyDiagram& diagram, const NumbersIn& ids) {
  std::size_t removed = 0;
  check(diagram.removeMany(vectorOf<SiteId>(ids), removed));
  return removed;
}

template <class AnyDiagram>
void updateMany(AnyDiagram& diagram, const NumbersIn& ids, const NumbersIn& xyr) {
  check(diagram.updateMany(vectorOf<SiteId>(ids), vectorOf<double>(xyr)));
}

template <class AnyDiagram>
void findMany(const AnyDiagram& diagram, const NumbersIn& xy, const NumbersOut& ids,
              const NumbersOut& distances) {
  const std::vector<double> points = vectorOf<double>(xy);
  const std::size_t count = points.size() / 2;
  auto found = allocating([&] { return std::vector<SiteId>(count); });
  auto far = allocating([&] { return std::vector<double>(distances.isNull() ? 0 : count); });
  check(diagram.findMany(points, found, far));
  ids.call<void>("set", viewOf(found));
  if (!distances.isNull()) distances.call<void>("set", viewOf(far));
}

void fromBytes(Diagram& diagram, const NumbersIn& bytes, Source source) {
  check(diagram.fromBytes(vectorOf<std::uint8_t>(bytes), source));
}

/// A broken invariant; none if the text is empty.
struct Found {
  std::string what;
  std::uint32_t where = 0;
  std::uint32_t level = 0;
};
template <class AnyDiagram>
Found validate(const AnyDiagram& diagram) {
  apollonius::Violation violation;
  check(diagram.validate(violation));
  return {allocating([&] { return std::string(violation.isFound() ? violation.what : ""); }),
          violation.where, violation.level};
}

// --- Building in steps. The calls are the diagram's, which a trap in one of them breaks.

/// The caller deletes it, before the diagram.
Builder* builder(Diagram& diagram, std::size_t count) {
  auto made = allocating([&] { return std::make_unique<Builder>(diagram); });
  check(made->reserve(count));
  return made.release();
}

void addTo(Diagram&, Builder& builder, const NumbersIn& xyr) {
  check(builder.add(vectorOf<double>(xyr)));
}

/// Is that all?
bool advance(Diagram&, Builder& builder, std::size_t steps) {
  bool isDone = false;
  check(builder.advance(steps, isDone));
  return isDone;
}

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
  for (const double distance : values) {
    if (std::isnan(distance)) check(Error::kNotFinite);
    const bool isUnlimited = distance == std::numeric_limits<double>::infinity();
    if (!isUnlimited && !apollonius::isInRange(distance)) check(Error::kOutOfRange);
  }
  return allocating([&] {
    return isById ? new Reach(std::span<const double>(values)) : new Reach(values.at(0));
  });
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
