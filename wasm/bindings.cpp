// What JavaScript sees of the library: plain exported functions of numbers, no logic.
//
// A diagram is its address, the first argument of most. Every fallible call returns the error code
// of apollonius/diagram.h as an integer. Scalar results are written to one block
// (`resultsAddress`), arrays in come from one scratch block (`reserve`), arrays out stay here until
// the next call or `release`. wasm/native.ts is the only other place that knows these blocks, and
// wasm/module.ts declares the functions for TypeScript.
//
// Embind is not used: with functions of numbers nothing is left for it to convert
// (docs/DECISIONS.md).
#include <emscripten/em_macros.h>

#include <array>
#include <cstdint>
#include <memory>
#include <new>
#include <string_view>
#include <utility>

#include "apollonius/diagram.h"
#include "apollonius/voronoi.h"

namespace {

using apollonius::Bounds;
using apollonius::Diagram;
using apollonius::Error;
using apollonius::SiteId;
using apollonius::Voronoi;

// The block of scalar results; wasm/native.ts repeats this order.
struct Results {
  double x, y, r, distance;
  std::uint32_t id, flag;
  std::array<std::uint32_t, 3> address, length;  // arrays out: first byte, number of elements
};
Results results;

// Arrays in, and arrays out whose length is known before the call.
struct Scratch {
  std::unique_ptr<double[]> data;
  std::size_t bytes = 0;
};

// What all diagrams share. Arrays out are kept alive until JavaScript has copied them.
struct Blocks {
  Scratch scratch;
  apollonius::Array<SiteId> siteIds;
  apollonius::VertexArrays vertexArrays;
  apollonius::EdgeArrays edgeArrays;
  apollonius::CurveArrays curveArrays;
  apollonius::RingArrays ringArrays;
  apollonius::Array<double> numbers;
  apollonius::Array<std::uint8_t> snapshot;
  apollonius::Path path;
};
Blocks blocks;
auto& [scratch, siteIds, vertexArrays, edgeArrays, curveArrays, ringArrays, numbers, snapshot,
       path] = blocks;

int code(Error error) { return static_cast<int>(error); }

template <class Container>
void publish(std::size_t slot, const Container& container) {
  results.address[slot] =
      static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(container.data()));
  results.length[slot] = static_cast<std::uint32_t>(container.size());
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

// --- What the module asks of wasm/module.ts

#define IMPORTED(name) __attribute__((import_module("env"), import_name(#name)))

// number/invariant.h: wasm has no stderr, and C's input and output would be 2 % of what a page
// loads.
IMPORTED(report) void report(const char* name);
void reportBrokenInvariant(const char* name) { report(name); }

// Instead of Emscripten's own (the linker's --wrap), which grows by as little as is asked for:
// malloc needs so many bytes; 1 if it has them.
IMPORTED(grow) int grow(std::size_t bytes);
int __wrap_emscripten_resize_heap(std::size_t bytes) { return grow(bytes); }

// --- Blocks

EMSCRIPTEN_KEEPALIVE const Results* resultsAddress() { return &results; }

// At least that many bytes, aligned for doubles; 0 if memory ran out. What an earlier call reserved
// is gone.
EMSCRIPTEN_KEEPALIVE double* reserve(std::size_t bytes) {
  if (bytes > scratch.bytes) {
    scratch = {};
    scratch.data.reset(new (std::nothrow) double[(bytes + sizeof(double) - 1) / sizeof(double)]);
    scratch.bytes = scratch.data == nullptr ? 0 : bytes;
  }
  return scratch.data.get();
}

// Gives all blocks back; JavaScript calls it when it has copied from large ones.
EMSCRIPTEN_KEEPALIVE void release() { blocks = Blocks(); }

// After a call that ended in its middle, when any block may be half-made: begins with new ones, and
// gives none back.
EMSCRIPTEN_KEEPALIVE void abandon() { new (&blocks) Blocks; }

// --- Life time, and calls about many sites or points. Addresses are of the scratch block.

// 0 if memory ran out.
EMSCRIPTEN_KEEPALIVE Diagram* diagramCreate(bool hierarchy) {
  try {
    return new Diagram(hierarchy ? apollonius::Location::kHierarchy : apollonius::Location::kWalk);
  } catch (...) {
    return nullptr;
  }
}

EMSCRIPTEN_KEEPALIVE void diagramDestroy(Diagram* diagram) { delete diagram; }

EMSCRIPTEN_KEEPALIVE void diagramClear(Diagram* diagram) { diagram->clear(); }

// The triples are in the scratch block, which is given up.
EMSCRIPTEN_KEEPALIVE int diagramInsertMany(Diagram* diagram, std::size_t count) {
  const Error error = diagram->insertMany(std::move(scratch.data), count, siteIds);
  scratch = {};
  publish(0, siteIds);
  return code(error);
}

EMSCRIPTEN_KEEPALIVE int diagramRemoveMany(Diagram* diagram, const SiteId* ids, std::size_t count) {
  std::size_t removed = 0;
  const Error error = diagram->removeMany({ids, count}, removed);
  results.flag = static_cast<std::uint32_t>(removed);
  return code(error);
}

EMSCRIPTEN_KEEPALIVE int diagramUpdateMany(Diagram* diagram, const SiteId* ids, const double* xyr,
                                           std::size_t count) {
  return code(diagram->updateMany({ids, count}, {xyr, 3 * count}));
}

EMSCRIPTEN_KEEPALIVE int diagramFindMany(const Diagram* diagram, const double* xy, SiteId* ids,
                                         double* distances, std::size_t count) {
  return code(diagram->findMany({xy, 2 * count}, {ids, count},
                                {distances, distances == nullptr ? 0 : count}));
}

EMSCRIPTEN_KEEPALIVE int diagramIds(const Diagram* diagram) {
  const Error error = diagram->ids(siteIds);
  publish(0, siteIds);
  return code(error);
}

EMSCRIPTEN_KEEPALIVE int diagramVertices(const Diagram* diagram) {
  const Error error = diagram->vertices(vertexArrays);
  publish(0, vertexArrays.coordinates);
  publish(1, vertexArrays.clearance);
  publish(2, vertexArrays.sites);
  return code(error);
}

EMSCRIPTEN_KEEPALIVE int diagramEdges(const Diagram* diagram) {
  const Error error = diagram->edges(edgeArrays);
  publish(0, edgeArrays.sites);
  publish(1, edgeArrays.vertices);
  return code(error);
}

// What is broken is left as text; where, in results.id and, the hierarchy's level, in results.flag.
EMSCRIPTEN_KEEPALIVE int diagramValidate(const Diagram* diagram) {
  apollonius::Violation violation;
  const Error error = diagram->validate(violation);
  publish(0, violation.isFound() ? std::string_view(violation.what) : std::string_view());
  results.id = violation.where;
  results.flag = violation.level;
  return code(error);
}

EMSCRIPTEN_KEEPALIVE int diagramToBytes(const Diagram* diagram) {
  const Error error = diagram->toBytes(snapshot);
  publish(0, snapshot);
  return code(error);
}

EMSCRIPTEN_KEEPALIVE int diagramFromBytes(Diagram* diagram, const std::uint8_t* content,
                                          std::size_t length, int isTrusted) {
  const auto source = isTrusted != 0 ? apollonius::Source::kTrusted : apollonius::Source::kAnyone;
  return code(diagram->fromBytes({content, length}, source));
}

// --- Calls about one site or point

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

EMSCRIPTEN_KEEPALIVE int diagramKNearest(const Diagram* diagram, double x, double y,
                                         std::uint32_t k) {
  const Error error = diagram->kNearest(x, y, k, siteIds);
  publish(0, siteIds);
  return code(error);
}

EMSCRIPTEN_KEEPALIVE int diagramWithin(const Diagram* diagram, double x, double y,
                                       double distance) {
  const Error error = diagram->within(x, y, distance, siteIds);
  publish(0, siteIds);
  return code(error);
}

EMSCRIPTEN_KEEPALIVE int diagramHas(const Diagram* diagram, SiteId id) {
  return diagram->has(id) ? 1 : 0;
}

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

// --- Geometry: bounds are four numbers, xmin, ymin, xmax, ymax

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

// Draws about `commands` commands from `cursor` on; then results.id is the next cursor and
// results.flag tells whether that was all.
EMSCRIPTEN_KEEPALIVE int diagramDraw(const Diagram* diagram, int what, double xmin, double ymin,
                                     double xmax, double ymax, double tolerance,
                                     std::uint32_t cursor, std::uint32_t commands) {
  const Voronoi voronoi(*diagram, {xmin, ymin, xmax, ymax});
  Voronoi::Portion portion{cursor, commands};
  const auto draw = [&] {
    switch (static_cast<Drawing>(what)) {
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
  const Error error = draw();
  results.id = static_cast<std::uint32_t>(portion.cursor);
  results.flag = portion.isDone ? 1 : 0;
  return publishPath(error);
}

EMSCRIPTEN_KEEPALIVE int voronoiDrawCell(const Diagram* diagram, double xmin, double ymin,
                                         double xmax, double ymax, SiteId id, double tolerance) {
  return publishPath(Voronoi(*diagram, {xmin, ymin, xmax, ymax}).drawCell(id, tolerance, path));
}

EMSCRIPTEN_KEEPALIVE int voronoiPolygon(const Diagram* diagram, double xmin, double ymin,
                                        double xmax, double ymax, SiteId id, double tolerance) {
  const Error error =
      Voronoi(*diagram, {xmin, ymin, xmax, ymax}).polygon(id, tolerance, ringArrays);
  publish(0, ringArrays.coordinates);
  publish(1, ringArrays.starts);
  return code(error);
}

EMSCRIPTEN_KEEPALIVE int voronoiCell(const Diagram* diagram, double xmin, double ymin, double xmax,
                                     double ymax, SiteId id) {
  const Error error = Voronoi(*diagram, {xmin, ymin, xmax, ymax}).cell(id, curveArrays);
  publish(0, curveArrays.curves);
  publish(1, curveArrays.sites);
  publish(2, curveArrays.regions);
  return code(error);
}

EMSCRIPTEN_KEEPALIVE int voronoiEdges(const Diagram* diagram, double xmin, double ymin, double xmax,
                                      double ymax) {
  const Error error = Voronoi(*diagram, {xmin, ymin, xmax, ymax}).edges(curveArrays);
  publish(0, curveArrays.curves);
  publish(1, curveArrays.sites);
  return code(error);
}

// results.distance is the area, r the perimeter, x and y the centroid; results.flag is 0 if there
// is none of it.
EMSCRIPTEN_KEEPALIVE int voronoiMeasures(const Diagram* diagram, double xmin, double ymin,
                                         double xmax, double ymax, SiteId id) {
  apollonius::CellMeasures measures;
  const Error error = Voronoi(*diagram, {xmin, ymin, xmax, ymax}).measures(id, measures);
  return publishMeasures(error, measures);
}

EMSCRIPTEN_KEEPALIVE int voronoiMeasuresWithin(const Diagram* diagram, SiteId id, double radius) {
  apollonius::CellMeasures measures;
  const Error error = Voronoi(*diagram).measuresWithin(id, radius, measures);
  return publishMeasures(error, measures);
}

EMSCRIPTEN_KEEPALIVE int voronoiAreas(const Diagram* diagram, double xmin, double ymin, double xmax,
                                      double ymax) {
  const Error error = Voronoi(*diagram, {xmin, ymin, xmax, ymax}).areas(numbers);
  publish(0, numbers);
  return code(error);
}

EMSCRIPTEN_KEEPALIVE std::uint32_t diagramSize(const Diagram* diagram) { return diagram->size(); }
EMSCRIPTEN_KEEPALIVE std::uint32_t diagramVisibleSize(const Diagram* diagram) {
  return diagram->visibleSize();
}

}  // extern "C"
