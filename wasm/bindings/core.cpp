// The part `core` for Embind, which writes the declarations that the TypeScript compiles against,
// build/wasm/apollonius.d.mts. When the module starts, it registers what a first insertion and
// query need, the rest when one of its calls is first made (docs/DECISIONS.md, "Start-up"). The
// parts `shapes` and `sphere` (shapes.cpp, sphere.cpp) are registered at their first use.
//
// A call that fails throws the number of its Error, which wasm/package/core/native/module.ts turns
// into an exception of the package. Arrays are copied, in both directions: a view of the memory
// becomes invalid when the memory grows.
#include <cstdlib>
#include <memory>
#include <optional>
#include <vector>

#include "adapters.h"
#include "apollonius/builder.h"
#include "apollonius/diagram.h"
#include "apollonius/nearest_first.h"
#include "apollonius/predicate_counts.h"
#include "apollonius/voronoi.h"
#include "parts.h"

using apollonius::Builder;
using apollonius::Circle;
using apollonius::Diagram;
using apollonius::NearestFirst;

/// The C++ runtime calls this when an exception leaves a function that must not throw, which never
/// happens here. The runtime's own version prints a message and would link all of printf.
extern "C" [[noreturn]] void abort_message(const char*, ...) { std::abort(); }

namespace {

Diagram* create() {
  return allocating([&] { return new Diagram(); });
}

/// Writes the new ids to an existing array, so that nothing can fail after the insertion.
void insertMany(Diagram& diagram, const NumbersIn& xyr, const NumbersOut& ids) {
  std::vector<SiteId> inserted;
  check(diagram.insertMany(vectorOf<double>(xyr), inserted));
  ids.call<void>("set", viewOf(inserted));
}

/// The handle through which the calls of Diagram are registered, some of them later. It is empty
/// until the module starts.
std::optional<emscripten::class_<Diagram>> diagramClass;

}  // namespace

EMSCRIPTEN_BINDINGS(core) {
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
      .value("kBusy", Error::kBusy)
      .value("kBroken", Error::kBroken);
  value_object<Nearest>("Nearest").field("id", &Nearest::id).field("distance", &Nearest::distance);

  diagramClass = registerDiagram<Diagram>("Diagram")
                     .constructor(&create, allow_raw_pointers())
                     .function("insertMany", &insertMany);

  if (areTypesWritten()) {
    registerCore();
    registerShapes();
    registerSphere();
  }
}

void expectRoom() {
  constexpr std::size_t kRoom = 1 << 12;  // bytes; of a part's 130 contexts each takes 24 at most
  allocating([] { ::operator delete(::operator new(kRoom)); });
}

void registerCore() {
  using namespace emscripten;

  value_object<Circle>("Circle")
      .field("x", &Circle::x)
      .field("y", &Circle::y)
      .field("r", &Circle::r);
  value_object<apollonius::NearbyLists>("NearbyLists")
      .field("ids", &apollonius::NearbyLists::ids)
      .field("starts", &apollonius::NearbyLists::starts)
      .field("distances", &apollonius::NearbyLists::distances);
  value_object<Found>("Found")
      .field("what", &Found::what)
      .field("where", &Found::where)
      .field("level", &Found::level);
  value_object<apollonius::SiteArrays>("SiteArrays")
      .field("ids", &apollonius::SiteArrays::ids)
      .field("xyr", &apollonius::SiteArrays::xyr)
      .field("hidden", &apollonius::SiteArrays::hidden);
  value_object<apollonius::VertexArrays>("VertexArrays")
      .field("xy", &apollonius::VertexArrays::coordinates)
      .field("clearance", &apollonius::VertexArrays::clearance)
      .field("sites", &apollonius::VertexArrays::sites);
  value_object<apollonius::EdgeArrays>("EdgeArrays")
      .field("sites", &apollonius::EdgeArrays::sites)
      .field("vertices", &apollonius::EdgeArrays::vertices);

  // Records of the parts `shapes` and `sphere`.
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

  diagramClass->function("search", returning<&Diagram::search>())
      .function("hull", returning<&Diagram::hull>())
      .function("levels", returning<&Diagram::levels>());
  registerOthers<NearestFirst, Builder>(*diagramClass, "NearestFirst", "Builder");
}
