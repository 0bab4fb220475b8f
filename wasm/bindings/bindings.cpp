// What JavaScript sees of the library, registered with Embind, which writes the declarations that
// the TypeScript compiles against, build/wasm/apollonius.d.mts.
//
// A call that fails throws the number of its Error, which wasm/package/native/module.ts turns
// into an exception of the package. Arrays are copied, in both directions: a view of the memory
// becomes invalid when the memory grows.
#include "spherical_adapters.h"
#include "voronoi_adapters.h"

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
      .value("kBusy", Error::kBusy)
      .value("kBroken", Error::kBroken);
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
  value_object<Conflict>("Conflict")
      .field("sites", &Conflict::sites)
      .field("isCovered", &Conflict::isCovered);
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
  class_<NearestFirst>("NearestFirst")
      .function("next", returning<&NearestFirst::next>())
      .function("distance", &NearestFirst::distance);
  class_<Diagram>("Diagram")
      .constructor(&create, allow_raw_pointers())
      // Sites
      .function("insert", returning<&Diagram::insert>())
      .function("insertMany", &insertMany)
      .function("remove", returning<&Diagram::remove>())
      .function("removeMany", &removeMany<Diagram>)
      .function("update", &update<Diagram>)
      .function("updateMany", &updateMany<Diagram>)
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
      .function("coverOf", returning<&Diagram::coverOf>())
      // Queries
      .function("find", &find<Diagram>)
      .function("nearest", &nearest<Diagram>)
      .function("findMany", &findMany<Diagram>)
      .function("kNearest", returning<&Diagram::kNearest>())
      .function("within", returning<&Diagram::within>())
      .function("pick", returning<&Diagram::pick>())
      .function("search", returning<&Diagram::search>())
      .function("nearestFirst", &nearestFirst<NearestFirst, Diagram>, allow_raw_pointers(), moved)
      .function("neighbors", returning<&Diagram::neighbors>())
      .function("conflict", &conflict)
      .function("vertices", returning<&Diagram::vertices>(), moved)
      .function("edges", returning<&Diagram::edges>(), moved)
      .function("levels", returning<&Diagram::levels>())
      // Snapshots
      .function("toBytes", returning<&Diagram::toBytes>())
      .function("fromBytes", &fromBytes)
      .function("validate", &validate<Diagram>)
      // Geometry
      .function("defaultTolerance", &defaultTolerance)
      .function("extent", &Voronoi::extentOf)
      .function("hull", &hull)
      .function("region", &makeRegion, allow_raw_pointers(), moved)
      .function("reach", &makeReach, allow_raw_pointers(), moved)
      .function("drawRegion", &drawRegion, moved)
      .function("fitAreas", &fitAreas, allow_raw_pointers(), moved)
      .function("finishFit", &finishFit)
      .function("draw", &draw, allow_raw_pointers(), moved)
      .function("drawCell", &drawCell, allow_raw_pointers(), moved)
      .function("cellPaths", &cellPaths, allow_raw_pointers(), moved)
      .function("cellPolygon", returning<&Voronoi::cellPolygon>(), allow_raw_pointers(), moved)
      .function("cellPolygons", returning<&Voronoi::cellPolygons>(), allow_raw_pointers(), moved)
      .function("cellCurves", returning<&Voronoi::cellCurves>(), allow_raw_pointers(), moved)
      .function("edgeCurves", returning<&Voronoi::edgeCurves>(), allow_raw_pointers(), moved)
      .function("cellMoments", returning<&Voronoi::cellMoments>(), allow_raw_pointers())
      .function("cellMeasures", returning<&Voronoi::cellMeasures>(), allow_raw_pointers())
      .function("cellMeasuresWithin", &measuresWithin)
      .function("cellAreas", returning<&Voronoi::cellAreas>(), allow_raw_pointers())
      .function("cellCentroids", returning<&Voronoi::cellCentroids>(), allow_raw_pointers())
      .function("cellPerimeters", returning<&Voronoi::cellPerimeters>(), allow_raw_pointers());
  registerSphere();
  class_<Region>("Region").function("box", &Region::box).function("contains", &Region::contains);
  class_<Reach>("Reach");
  class_<Fitting>("Fitting")
      .function("step", &stepFit)
      .function("isAtTheEndOfDoubles", &isAtTheEndOfDoubles)
      .function("error", &fitError)
      .function("badSite", &badSite)
      .function("weights", &fitWeights);
}
