// What JavaScript sees of the library, registered with Embind, and the functions that adapt it.
// Embind writes the declarations that the TypeScript around it compiles against,
// build/wasm/apollonius.d.mts.
//
// A call that fails throws the number of its Error, which wasm/package/module.ts turns into an
// exception of the package. Arrays are copied, in both directions: a view of the memory dies when
// that grows. Records come in as numbers one by one, because Embind would leak one whose call
// throws.
#include <emscripten/bind.h>

#include <cstdint>
#include <memory>
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
using apollonius::Region;
using apollonius::SiteId;
using apollonius::Source;
using apollonius::Top;
using apollonius::Voronoi;
using emscripten::val;

namespace {

// --- Calls

template <std::size_t k, class... Types>
using Nth = std::tuple_element_t<k, std::tuple<Types...>>;

/// `Error method(in..., Out& out)` of a class as a function of the object and `in` that returns
/// `out`.
template <auto method, class Class, class... Parameters, std::size_t... k>
auto returning(Error (Class::*)(Parameters...), std::index_sequence<k...>) {
  return +[](Class& object, Nth<k, Parameters...>... in) {
    std::remove_reference_t<Nth<sizeof...(k), Parameters...>> out{};
    check((object.*method)(in..., out));
    return out;
  };
}
template <auto method, class Class, class... Parameters, std::size_t... k>
auto returning(Error (Class::*)(Parameters...) const, std::index_sequence<k...>) {
  return +[](const Class& object, Nth<k, Parameters...>... in) {
    std::remove_reference_t<Nth<sizeof...(k), Parameters...>> out{};
    check((object.*method)(in..., out));
    return out;
  };
}
/// The cells in a region, or in bounds if `region` is null.
Voronoi voronoiIn(const Diagram& diagram, const Region* region, const Bounds& bounds) {
  return region == nullptr ? Voronoi(diagram, bounds) : Voronoi(diagram, *region);
}

/// Overload for methods of Voronoi: a function of the diagram and the window.
template <auto method, class... Parameters, std::size_t... k>
auto returning(Error (Voronoi::*)(Parameters...) const, std::index_sequence<k...>) {
  return +[](const Diagram& diagram, const Region* region, double xmin, double ymin, double xmax,
             double ymax, Nth<k, Parameters...>... in) {
    std::remove_reference_t<Nth<sizeof...(k), Parameters...>> out{};
    check((voronoiIn(diagram, region, {xmin, ymin, xmax, ymax}).*method)(in..., out));
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

/// -1 if there is none.
std::int32_t asSigned(SiteId id) { return static_cast<std::int32_t>(id); }

struct Nearest {
  std::int32_t id = -1;
  double distance = 0;
};
Nearest nearest(const Diagram& diagram, double x, double y) {
  SiteId id = apollonius::kNoSite;
  double distance = 0;
  check(diagram.find(x, y, id, distance));
  return {asSigned(id), distance};
}
std::int32_t find(const Diagram& diagram, double x, double y) {
  SiteId id = apollonius::kNoSite;
  check(diagram.find(x, y, id));
  return asSigned(id);
}

std::int32_t pick(const Diagram& diagram, double x, double y, double farthest, Top top) {
  SiteId id = apollonius::kNoSite;
  check(diagram.pick(x, y, farthest, top, id));
  return asSigned(id);
}

/// The caller deletes it, before the diagram changes.
NearestFirst* nearestFirst(const Diagram& diagram, double x, double y, double farthest) {
  auto walk = allocating([&] { return std::make_unique<NearestFirst>(diagram); });
  check(walk->start(x, y, farthest));
  return walk.release();
}
std::int32_t next(NearestFirst& walk) {
  SiteId id = apollonius::kNoSite;
  check(walk.next(id));
  return asSigned(id);
}

std::int32_t coverOf(const Diagram& diagram, SiteId id) {
  SiteId cover = apollonius::kNoSite;
  check(diagram.coverOf(id, cover));
  return asSigned(cover);
}

void update(Diagram& diagram, SiteId id, double x, double y, double r) {
  check(diagram.update(id, x, y, r));
}

/// The new ids go to an array that is there before, so that nothing can fail when all are in.
void insertMany(Diagram& diagram, const NumbersIn& xyr, const NumbersOut& ids) {
  std::vector<SiteId> inserted;
  check(diagram.insertMany(vectorOf<double>(xyr), inserted));
  ids.call<void>("set", viewOf(inserted));
}

std::size_t removeMany(Diagram& diagram, const NumbersIn& ids) {
  std::size_t removed = 0;
  check(diagram.removeMany(vectorOf<SiteId>(ids), removed));
  return removed;
}

void updateMany(Diagram& diagram, const NumbersIn& ids, const NumbersIn& xyr) {
  check(diagram.updateMany(vectorOf<SiteId>(ids), vectorOf<double>(xyr)));
}

void findMany(const Diagram& diagram, const NumbersIn& xy, const NumbersOut& ids,
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
Found validate(const Diagram& diagram) {
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
Portion draw(const Diagram& diagram, const Region* region, double xmin, double ymin, double xmax,
             double ymax, Drawing what, double tolerance, std::size_t cursor,
             std::size_t commands) {
  const Voronoi voronoi = voronoiIn(diagram, region, {xmin, ymin, xmax, ymax});
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

Portion drawCell(const Diagram& diagram, const Region* region, double xmin, double ymin,
                 double xmax, double ymax, SiteId id, double tolerance) {
  apollonius::Path path;
  check(voronoiIn(diagram, region, {xmin, ymin, xmax, ymax}).drawCell(id, tolerance, path));
  return {std::move(path.commands), std::move(path.coordinates)};
}

/// A region for windows on diagrams of this instance of the module.
Region* makeRegion(const Diagram&, const NumbersIn& coordinates, const NumbersIn& starts) {
  Region region;
  check(region.assign(vectorOf<double>(coordinates), vectorOf<std::uint32_t>(starts)));
  return allocating([&] { return new Region(std::move(region)); });
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
Fitting* fitAreas(const Diagram& diagram, const Region* region, double xmin, double ymin,
                  double xmax, double ymax, const NumbersIn& targets, const NumbersIn& start) {
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

EMSCRIPTEN_BINDINGS(apollonius) {
  using namespace emscripten;

  register_type<Uint8Array>("Uint8Array<ArrayBuffer>");
  register_type<Int32Array>("Int32Array<ArrayBuffer>");
  register_type<Uint32Array>("Uint32Array<ArrayBuffer>");
  register_type<Float64Array>("Float64Array<ArrayBuffer>");
  register_type<NumbersIn>("ArrayLike<number>");
  register_type<NumbersOut>("Int32Array | Uint32Array | Float64Array | null");

  enum_<Error>("Error")
      .value("kNone", Error::kNone)
      .value("kNotFinite", Error::kNotFinite)
      .value("kOutOfRange", Error::kOutOfRange)
      .value("kUnknownSite", Error::kUnknownSite)
      .value("kBadLength", Error::kBadLength)
      .value("kOutOfMemory", Error::kOutOfMemory)
      .value("kTooLarge", Error::kTooLarge)
      .value("kBadBounds", Error::kBadBounds)
      .value("kCorruptSnapshot", Error::kCorruptSnapshot)
      .value("kBadTarget", Error::kBadTarget)
      .value("kNoConvergence", Error::kNoConvergence)
      .value("kBusy", Error::kBusy);
  enum_<Location>("Location")
      .value("walk", Location::kWalk)
      .value("hierarchy", Location::kHierarchy);
  enum_<Source>("Source").value("anyone", Source::kAnyone).value("trusted", Source::kTrusted);
  enum_<Top>("Top").value("smallest", Top::kSmallest).value("last", Top::kLast);
  enum_<Drawing>("Drawing")
      .value("edges", Drawing::kEdges)
      .value("sites", Drawing::kSites)
      .value("dual", Drawing::kDual)
      .value("dualWithRays", Drawing::kDualWithRays)
      .value("hull", Drawing::kHull);

  value_object<Circle>("Circle")
      .field("x", &Circle::x)
      .field("y", &Circle::y)
      .field("r", &Circle::r);
  value_object<Nearest>("Nearest").field("id", &Nearest::id).field("distance", &Nearest::distance);
  value_object<Found>("Found")
      .field("what", &Found::what)
      .field("where", &Found::where)
      .field("level", &Found::level);
  value_object<Bounds>("Bounds")
      .field("xmin", &Bounds::xmin)
      .field("ymin", &Bounds::ymin)
      .field("xmax", &Bounds::xmax)
      .field("ymax", &Bounds::ymax);
  value_object<apollonius::SiteArrays>("SiteArrays")
      .field("ids", &apollonius::SiteArrays::ids)
      .field("xyr", &apollonius::SiteArrays::xyr)
      .field("hidden", &apollonius::SiteArrays::hidden);
  value_object<apollonius::VertexArrays>("VertexArrays")
      .field("coordinates", &apollonius::VertexArrays::coordinates)
      .field("clearance", &apollonius::VertexArrays::clearance)
      .field("sites", &apollonius::VertexArrays::sites);
  value_object<apollonius::EdgeArrays>("EdgeArrays")
      .field("sites", &apollonius::EdgeArrays::sites)
      .field("vertices", &apollonius::EdgeArrays::vertices);
  value_object<apollonius::CurveArrays>("CurveArrays")
      .field("curves", &apollonius::CurveArrays::curves)
      .field("sites", &apollonius::CurveArrays::sites)
      .field("starts", &apollonius::CurveArrays::starts);
  value_object<apollonius::RingArrays>("RingArrays")
      .field("coordinates", &apollonius::RingArrays::coordinates)
      .field("starts", &apollonius::RingArrays::starts)
      .field("parts", &apollonius::RingArrays::parts);
  value_object<apollonius::CoverageArrays>("CoverageArrays")
      .field("coordinates", &apollonius::CoverageArrays::coordinates)
      .field("starts", &apollonius::CoverageArrays::starts)
      .field("parts", &apollonius::CoverageArrays::parts)
      .field("sites", &apollonius::CoverageArrays::sites)
      .field("cells", &apollonius::CoverageArrays::cells);
  value_object<apollonius::CellMeasures>("CellMeasures")
      .field("area", &apollonius::CellMeasures::area)
      .field("centroidX", &apollonius::CellMeasures::centroidX)
      .field("centroidY", &apollonius::CellMeasures::centroidY)
      .field("perimeter", &apollonius::CellMeasures::perimeter)
      .field("isEmpty", &apollonius::CellMeasures::isEmpty);
  value_object<Portion>("Portion")
      .field("commands", &Portion::commands)
      .field("coordinates", &Portion::coordinates)
      .field("cursor", &Portion::cursor)
      .field("isDone", &Portion::isDone);

  value_object<apollonius::StageCounts>("StageCounts")
      .field("filter", &apollonius::StageCounts::filter)
      .field("middle", &apollonius::StageCounts::middle)
      .field("exact", &apollonius::StageCounts::exact);
  value_object<apollonius::PredicateCounts>("PredicateCounts")
      .field("covers", &apollonius::PredicateCounts::covers)
      .field("distance", &apollonius::PredicateCounts::distance)
      .field("bearing", &apollonius::PredicateCounts::bearing)
      .field("vertexConflict", &apollonius::PredicateCounts::vertexConflict)
      .field("edgeConflict", &apollonius::PredicateCounts::edgeConflict)
      .field("ties", &apollonius::PredicateCounts::ties);
  function("predicateCounts", &apollonius::predicateCounts);

  const return_value_policy::take_ownership moved;  // not copied
  class_<Builder>("Builder").function("progress", &Builder::progress);
  class_<NearestFirst>("NearestFirst").function("next", &next);
  class_<Diagram>("Diagram")
      .constructor(&create, allow_raw_pointers())
      // Sites
      .function("insert", returning<&Diagram::insert>())
      .function("insertMany", &insertMany)
      .function("remove", returning<&Diagram::remove>())
      .function("removeMany", &removeMany)
      .function("update", &update)
      .function("updateMany", &updateMany)
      .function("builder", &builder, allow_raw_pointers(), moved)
      .function("addTo", &addTo)
      .function("advance", &advance)
      .function("clear", &Diagram::clear)
      .function("size", &Diagram::size)
      .function("visibleSize", &Diagram::visibleSize)
      .function("has", &Diagram::has)
      .function("site", returning<&Diagram::site>())
      .function("ids", returning<&Diagram::ids>())
      .function("sites", returning<&Diagram::sites>(), moved)
      .function("isHidden", returning<&Diagram::isHidden>())
      .function("coverOf", &coverOf)
      // Queries
      .function("find", &find)
      .function("nearest", &nearest)
      .function("findMany", &findMany)
      .function("kNearest", returning<&Diagram::kNearest>())
      .function("within", returning<&Diagram::within>())
      .function("pick", &pick)
      .function("search", returning<&Diagram::search>())
      .function("nearestFirst", &nearestFirst, allow_raw_pointers(), moved)
      .function("neighbors", returning<&Diagram::neighbors>())
      .function("vertices", returning<&Diagram::vertices>(), moved)
      .function("edges", returning<&Diagram::edges>(), moved)
      .function("levels", returning<&Diagram::levels>())
      // Snapshots
      .function("toBytes", returning<&Diagram::toBytes>())
      .function("fromBytes", &fromBytes)
      .function("validate", &validate)
      // Geometry
      .function("defaultTolerance", &defaultTolerance)
      .function("extent", &Voronoi::extentOf)
      .function("hull", &hull)
      .function("region", &makeRegion, allow_raw_pointers(), moved)
      .function("drawRegion", &drawRegion, moved)
      .function("fitAreas", &fitAreas, allow_raw_pointers(), moved)
      .function("finishFit", &finishFit)
      .function("draw", &draw, allow_raw_pointers(), moved)
      .function("drawCell", &drawCell, allow_raw_pointers(), moved)
      .function("cellPolygon", returning<&Voronoi::cellPolygon>(), allow_raw_pointers(), moved)
      .function("cellPolygons", returning<&Voronoi::cellPolygons>(), allow_raw_pointers(), moved)
      .function("cellCurves", returning<&Voronoi::cellCurves>(), allow_raw_pointers(), moved)
      .function("edgeCurves", returning<&Voronoi::edgeCurves>(), allow_raw_pointers(), moved)
      .function("cellMeasures", returning<&Voronoi::cellMeasures>(), allow_raw_pointers())
      .function("cellMeasuresWithin", &measuresWithin)
      .function("cellAreas", returning<&Voronoi::cellAreas>(), allow_raw_pointers())
      .function("cellCentroids", returning<&Voronoi::cellCentroids>(), allow_raw_pointers())
      .function("cellPerimeters", returning<&Voronoi::cellPerimeters>(), allow_raw_pointers());
  class_<Region>("Region").function("box", &Region::box);
  class_<Fitting>("Fitting")
      .function("step", &stepFit)
      .function("isAtTheEndOfDoubles", &isAtTheEndOfDoubles)
      .function("error", &fitError)
      .function("badSite", &badSite)
      .function("weights", &fitWeights);
}
