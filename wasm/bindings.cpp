// What JavaScript sees of the library: registration only, no logic.
//
// Two kinds of exports, because a call through embind costs about 0.2 us when eval is off (a strict content security
// policy allows none) and a direct one about 0.013 us:
// - functions by embind: life time, and calls about many sites or points;
// - `diagram...` functions, exported as they are: calls about one site or point.
// Both take the diagram's address first. Embind could register a class, but what its JavaScript does for classes (inheritance,
// smart pointers, overloads) is larger than the library's own, and native.ts needs none of it.
// Every fallible call returns the error code of apollonius.h as an integer. Scalar results are written to one block
// (`resultsAddress`), arrays in come from one scratch block (`reserve`), arrays out stay in vectors here until the next call
// or `release`. wasm/native.ts is the only other place that knows these blocks.
#include <emscripten/bind.h>
#include <emscripten/em_macros.h>

#include <array>
#include <cstdint>
#include <memory>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include "apollonius.h"
#include "voronoi.h"

namespace {

using apollonius::Bounds;
using apollonius::Diagram;
using apollonius::Error;
using apollonius::SiteId;
using apollonius::Voronoi;
using Address = std::uintptr_t;

// The block of scalar results; wasm/native.ts repeats this order.
struct Results {
  double x, y, r, distance;
  std::uint32_t id, flag;
  std::array<std::uint32_t, 3> address, length;  // arrays out: first byte, number of elements
};
Results results;

// Arrays out, kept alive until JavaScript has copied them.
std::vector<SiteId> siteIds;
apollonius::VertexArrays vertexArrays;
apollonius::EdgeArrays edgeArrays;
apollonius::CurveArrays curveArrays;
apollonius::RingArrays ringArrays;
std::vector<double> numbers;
std::vector<std::uint8_t> snapshot;
apollonius::Path path;
std::string text;

// Arrays in, and arrays out whose length is known before the call.
struct Scratch {
  std::unique_ptr<double[]> data;
  std::size_t bytes = 0;
};
Scratch scratch;

int code(Error error) { return static_cast<int>(error); }

template <class Element>
Element* at(Address address) {
  return reinterpret_cast<Element*>(address);  // NOLINT: an address that JavaScript got from `reserve`
}

template <class Container>
void publish(std::size_t slot, const Container& container) {
  results.address[slot] = static_cast<std::uint32_t>(reinterpret_cast<Address>(container.data()));
  results.length[slot] = static_cast<std::uint32_t>(container.size());
}

Address resultsAddress() { return reinterpret_cast<Address>(&results); }

// At least that many bytes, aligned for doubles; 0 if memory ran out. What an earlier call reserved is gone.
Address reserve(std::size_t bytes) {
  if (bytes > scratch.bytes) {
    scratch = {};
    scratch.data.reset(new (std::nothrow) double[(bytes + sizeof(double) - 1) / sizeof(double)]);
    scratch.bytes = scratch.data == nullptr ? 0 : bytes;
  }
  return reinterpret_cast<Address>(scratch.data.get());
}

// Gives all blocks back; JavaScript calls it when it has copied from large ones.
void release() {
  scratch = {};
  siteIds = std::vector<SiteId>();  // not {}: that would only empty a vector or string
  vertexArrays = {};
  edgeArrays = {};
  curveArrays = {};
  ringArrays = {};
  numbers = std::vector<double>();
  snapshot = std::vector<std::uint8_t>();
  path = {};
  text = std::string();
}

// The address of a new diagram; 0 if memory ran out.
Address create(bool hierarchy) {
  try {
    return reinterpret_cast<Address>(new Diagram(hierarchy ? apollonius::Location::kHierarchy : apollonius::Location::kWalk));
  } catch (...) {
    return 0;
  }
}

void destroy(Address diagram) { delete at<Diagram>(diagram); }

void clear(Diagram& diagram) { diagram.clear(); }

// The triples are in the scratch block, which is given up.
int insertMany(Diagram& diagram, std::size_t count) {
  const Error error = diagram.insertMany(std::move(scratch.data), count, siteIds);
  scratch = {};
  publish(0, siteIds);
  return code(error);
}

int removeMany(Diagram& diagram, Address ids, std::size_t count) {
  std::size_t removed = 0;
  const Error error = diagram.removeMany({at<const SiteId>(ids), count}, removed);
  results.flag = static_cast<std::uint32_t>(removed);
  return code(error);
}

int updateMany(Diagram& diagram, Address ids, Address xyr, std::size_t count) {
  return code(diagram.updateMany({at<const SiteId>(ids), count}, {at<const double>(xyr), 3 * count}));
}

int findMany(const Diagram& diagram, Address xy, Address ids, Address distances, std::size_t count) {
  return code(diagram.findMany({at<const double>(xy), 2 * count}, {at<SiteId>(ids), count},
                               {at<double>(distances), distances == 0 ? 0 : count}));
}

int ids(const Diagram& diagram) {
  const Error error = diagram.ids(siteIds);
  publish(0, siteIds);
  return code(error);
}

int vertices(const Diagram& diagram) {
  const Error error = diagram.vertices(vertexArrays);
  publish(0, vertexArrays.coordinates);
  publish(1, vertexArrays.clearance);
  publish(2, vertexArrays.sites);
  return code(error);
}

int edges(const Diagram& diagram) {
  const Error error = diagram.edges(edgeArrays);
  publish(0, edgeArrays.sites);
  publish(1, edgeArrays.vertices);
  return code(error);
}

int validate(const Diagram& diagram) {
  const Error error = diagram.validate(text);
  publish(0, text);
  return code(error);
}

int toBytes(const Diagram& diagram) {
  const Error error = diagram.toBytes(snapshot);
  publish(0, snapshot);
  return code(error);
}

int fromBytes(Diagram& diagram, Address content, std::size_t length) {
  return code(diagram.fromBytes({at<const std::uint8_t>(content), length}));
}

int publishMeasures(Error error, const apollonius::CellMeasures& measures) {
  results.x = measures.centroidX;
  results.y = measures.centroidY;
  results.r = measures.perimeter;
  results.distance = measures.area;
  results.flag = measures.isEmpty ? 0 : 1;
  return code(error);
}

int publishPath(Error error) {
  publish(0, path.coordinates);
  publish(1, path.commands);
  return code(error);
}

// What `diagramDraw` draws; wasm/native.ts repeats this order.
enum class Drawing { kEdges, kSites, kDual, kDualWithRays, kHull };

}  // namespace

extern "C" {

EMSCRIPTEN_KEEPALIVE int diagramInsert(Diagram* diagram, double x, double y, double r) {
  return code(diagram->insert(x, y, r, results.id));
}

EMSCRIPTEN_KEEPALIVE int diagramRemove(Diagram* diagram, SiteId id) {
  bool removed = false;
  const Error error = diagram->remove(id, removed);
  results.flag = removed ? 1 : 0;
  return code(error);
}

EMSCRIPTEN_KEEPALIVE int diagramUpdate(Diagram* diagram, SiteId id, double x, double y, double r) {
  return code(diagram->update(id, x, y, r));
}

EMSCRIPTEN_KEEPALIVE int diagramFind(const Diagram* diagram, double x, double y) {
  return code(diagram->find(x, y, results.id, results.distance));
}

EMSCRIPTEN_KEEPALIVE int diagramKNearest(const Diagram* diagram, double x, double y, std::uint32_t k) {
  const Error error = diagram->kNearest(x, y, k, siteIds);
  publish(0, siteIds);
  return code(error);
}

EMSCRIPTEN_KEEPALIVE int diagramWithin(const Diagram* diagram, double x, double y, double distance) {
  const Error error = diagram->within(x, y, distance, siteIds);
  publish(0, siteIds);
  return code(error);
}

EMSCRIPTEN_KEEPALIVE int diagramHas(const Diagram* diagram, SiteId id) { return diagram->has(id) ? 1 : 0; }

EMSCRIPTEN_KEEPALIVE int diagramSite(const Diagram* diagram, SiteId id) {
  apollonius::Circle circle{};
  const Error error = diagram->site(id, circle);
  results.x = circle.x;
  results.y = circle.y;
  results.r = circle.r;
  return code(error);
}

EMSCRIPTEN_KEEPALIVE int diagramIsHidden(const Diagram* diagram, SiteId id) {
  bool hidden = false;
  const Error error = diagram->isHidden(id, hidden);
  results.flag = hidden ? 1 : 0;
  return code(error);
}

EMSCRIPTEN_KEEPALIVE int diagramCoverOf(const Diagram* diagram, SiteId id) {
  return code(diagram->coverOf(id, results.id));
}

EMSCRIPTEN_KEEPALIVE int diagramNeighbors(const Diagram* diagram, SiteId id) {
  const Error error = diagram->neighbors(id, siteIds);
  publish(0, siteIds);
  return code(error);
}

// --- Geometry: bounds are four numbers, xmin, ymin, xmax, ymax -------------------------------------------------------------------

EMSCRIPTEN_KEEPALIVE double toleranceFor(double xmin, double ymin, double xmax, double ymax) {
  return apollonius::defaultTolerance({xmin, ymin, xmax, ymax});
}

EMSCRIPTEN_KEEPALIVE void diagramExtent(const Diagram* diagram) {
  const Bounds box = Voronoi::extentOf(*diagram);
  results.x = box.xmin;
  results.y = box.ymin;
  results.r = box.xmax;
  results.distance = box.ymax;
}

EMSCRIPTEN_KEEPALIVE int diagramHull(const Diagram* diagram) {
  const Error error = Voronoi(*diagram).hull(siteIds);
  publish(0, siteIds);
  return code(error);
}

// Draws about `commands` commands from `cursor` on; then results.id is the next cursor and results.flag tells whether that was all.
EMSCRIPTEN_KEEPALIVE int diagramDraw(const Diagram* diagram, int what, double xmin, double ymin, double xmax, double ymax,
                                     double tolerance, std::uint32_t cursor, std::uint32_t commands) {
  const Voronoi voronoi(*diagram, {xmin, ymin, xmax, ymax});
  Voronoi::Portion portion{cursor, commands};
  const auto draw = [&] {
    switch (static_cast<Drawing>(what)) {
      case Drawing::kEdges: return voronoi.drawEdges(tolerance, portion, path);
      case Drawing::kSites: return voronoi.drawSites(tolerance, portion, path);
      case Drawing::kDual: return voronoi.drawDual(tolerance, false, portion, path);
      case Drawing::kDualWithRays: return voronoi.drawDual(tolerance, true, portion, path);
      case Drawing::kHull: break;
    }
    portion.isDone = true;
    return voronoi.drawHull(tolerance, path);
  };
  const Error error = draw();
  results.id = static_cast<std::uint32_t>(portion.cursor);
  results.flag = portion.isDone ? 1 : 0;
  return publishPath(error);
}

EMSCRIPTEN_KEEPALIVE int voronoiDrawCell(const Diagram* diagram, double xmin, double ymin, double xmax, double ymax, SiteId id,
                                         double tolerance) {
  return publishPath(Voronoi(*diagram, {xmin, ymin, xmax, ymax}).drawCell(id, tolerance, path));
}

EMSCRIPTEN_KEEPALIVE int voronoiPolygon(const Diagram* diagram, double xmin, double ymin, double xmax, double ymax, SiteId id,
                                        double tolerance) {
  const Error error = Voronoi(*diagram, {xmin, ymin, xmax, ymax}).polygon(id, tolerance, ringArrays);
  publish(0, ringArrays.coordinates);
  publish(1, ringArrays.starts);
  return code(error);
}

EMSCRIPTEN_KEEPALIVE int voronoiCell(const Diagram* diagram, double xmin, double ymin, double xmax, double ymax, SiteId id) {
  const Error error = Voronoi(*diagram, {xmin, ymin, xmax, ymax}).cell(id, curveArrays);
  publish(0, curveArrays.curves);
  publish(1, curveArrays.sites);
  publish(2, curveArrays.regions);
  return code(error);
}

EMSCRIPTEN_KEEPALIVE int voronoiEdges(const Diagram* diagram, double xmin, double ymin, double xmax, double ymax) {
  const Error error = Voronoi(*diagram, {xmin, ymin, xmax, ymax}).edges(curveArrays);
  publish(0, curveArrays.curves);
  publish(1, curveArrays.sites);
  return code(error);
}

// results.distance is the area, r the perimeter, x and y the centroid; results.flag is 0 if there is none of it.
EMSCRIPTEN_KEEPALIVE int voronoiMeasures(const Diagram* diagram, double xmin, double ymin, double xmax, double ymax, SiteId id) {
  apollonius::CellMeasures measures;
  const Error error = Voronoi(*diagram, {xmin, ymin, xmax, ymax}).measures(id, measures);
  return publishMeasures(error, measures);
}

EMSCRIPTEN_KEEPALIVE int voronoiMeasuresWithin(const Diagram* diagram, SiteId id, double radius) {
  apollonius::CellMeasures measures;
  const Error error = Voronoi(*diagram).measuresWithin(id, radius, measures);
  return publishMeasures(error, measures);
}

EMSCRIPTEN_KEEPALIVE int voronoiAreas(const Diagram* diagram, double xmin, double ymin, double xmax, double ymax) {
  const Error error = Voronoi(*diagram, {xmin, ymin, xmax, ymax}).areas(numbers);
  publish(0, numbers);
  return code(error);
}

EMSCRIPTEN_KEEPALIVE std::uint32_t diagramSize(const Diagram* diagram) { return diagram->size(); }
EMSCRIPTEN_KEEPALIVE std::uint32_t diagramVisibleSize(const Diagram* diagram) { return diagram->visibleSize(); }

}  // extern "C"

namespace {

// Registers a function of a diagram as one of the diagram's address.
template <auto function, class Result, class Subject, class... Arguments>
void registerMethod(const char* name, Result (*)(Subject&, Arguments...)) {
  emscripten::function(name, +[](Address diagram, Arguments... arguments) -> Result {
    return function(*at<Subject>(diagram), arguments...);
  });
}
template <auto function>
void method(const char* name) {
  registerMethod<function>(name, function);
}

}  // namespace

EMSCRIPTEN_BINDINGS(apollonius) {
  emscripten::function("resultsAddress", &resultsAddress);
  emscripten::function("reserve", &reserve);
  emscripten::function("release", &release);
  emscripten::function("create", &create);
  emscripten::function("destroy", &destroy);
  method<&insertMany>("insertMany");
  method<&removeMany>("removeMany");
  method<&updateMany>("updateMany");
  method<&findMany>("findMany");
  method<&clear>("clear");
  method<&ids>("ids");
  method<&vertices>("vertices");
  method<&edges>("edges");
  method<&validate>("validate");
  method<&toBytes>("toBytes");
  method<&fromBytes>("fromBytes");
}
