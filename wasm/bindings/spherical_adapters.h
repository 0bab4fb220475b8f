// The diagram of the sphere for Embind: its adapters and registrations, for bindings.cpp.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "adapters.h"
#include "apollonius/spherical_diagram.h"

using apollonius::SphericalCircle;
using apollonius::SphericalDiagram;
using apollonius::SphericalNearestFirst;
using apollonius::SphericalPoint;

namespace {

/// REQUIRES: a radius that a sphere can have.
SphericalDiagram* createSpherical(double radius) {
  return allocating([&] { return new SphericalDiagram(radius); });
}

Nearest nearestOnSphere(const SphericalDiagram& diagram, double lon, double lat) {
  SiteId id = apollonius::kNoSite;
  double distance = 0;
  check(diagram.find(lon, lat, id, distance));
  return {asSigned(id), distance};
}
std::int32_t findOnSphere(const SphericalDiagram& diagram, double lon, double lat) {
  SiteId id = apollonius::kNoSite;
  check(diagram.find(lon, lat, id));
  return asSigned(id);
}

/// The caller deletes it, before the diagram changes.
SphericalNearestFirst* nearestFirstOnSphere(const SphericalDiagram& diagram, double lon, double lat,
                                            double farthest) {
  auto walk = allocating([&] { return std::make_unique<SphericalNearestFirst>(diagram); });
  check(walk->start(lon, lat, farthest));
  return walk.release();
}
std::int32_t nextOnSphere(SphericalNearestFirst& walk) {
  SiteId id = apollonius::kNoSite;
  check(walk.next(id));
  return asSigned(id);
}

std::int32_t coverOnSphere(const SphericalDiagram& diagram, SiteId id) {
  SiteId cover = apollonius::kNoSite;
  check(diagram.coverOf(id, cover));
  return asSigned(cover);
}

void updateOnSphere(SphericalDiagram& diagram, SiteId id, double lon, double lat, double r) {
  check(diagram.update(id, lon, lat, r));
}

/// The new ids go to an array that is there before, so that nothing can fail when all are in.
void insertManyOnSphere(SphericalDiagram& diagram, const NumbersIn& sites, const NumbersOut& ids) {
  const std::vector<double> numbers = vectorOf<double>(sites);
  auto inserted = allocating([&] { return std::vector<SiteId>(numbers.size() / 3); });
  check(diagram.insertMany(numbers, inserted));
  ids.call<void>("set", viewOf(inserted));
}

std::size_t removeManyOnSphere(SphericalDiagram& diagram, const NumbersIn& ids) {
  std::size_t removed = 0;
  check(diagram.removeMany(vectorOf<SiteId>(ids), removed));
  return removed;
}

void updateManyOnSphere(SphericalDiagram& diagram, const NumbersIn& ids, const NumbersIn& sites) {
  check(diagram.updateMany(vectorOf<SiteId>(ids), vectorOf<double>(sites)));
}

void findManyOnSphere(const SphericalDiagram& diagram, const NumbersIn& lonLat,
                      const NumbersOut& ids, const NumbersOut& distances) {
  const std::vector<double> points = vectorOf<double>(lonLat);
  const std::size_t count = points.size() / 2;
  auto found = allocating([&] { return std::vector<SiteId>(count); });
  auto far = allocating([&] { return std::vector<double>(distances.isNull() ? 0 : count); });
  check(diagram.findMany(points, found, far));
  ids.call<void>("set", viewOf(found));
  if (!distances.isNull()) distances.call<void>("set", viewOf(far));
}

void sphereFromBytes(SphericalDiagram& diagram, const NumbersIn& bytes) {
  check(diagram.fromBytes(vectorOf<std::uint8_t>(bytes)));
}

Found validateSphere(const SphericalDiagram& diagram) {
  apollonius::Violation violation;
  check(diagram.validate(violation));
  return {allocating([&] { return std::string(violation.isFound() ? violation.what : ""); }),
          violation.where, violation.level};
}

void registerSphere() {
  using namespace emscripten;
  const return_value_policy::take_ownership moved;  // not copied
  value_object<SphericalCircle>("SphericalCircle")
      .field("lon", &SphericalCircle::lon)
      .field("lat", &SphericalCircle::lat)
      .field("r", &SphericalCircle::r);
  value_object<SphericalPoint>("SphericalPoint")
      .field("lon", &SphericalPoint::lon)
      .field("lat", &SphericalPoint::lat);
  class_<SphericalNearestFirst>("SphericalNearestFirst").function("next", &nextOnSphere);
  class_<SphericalDiagram>("SphericalDiagram")
      .constructor(&createSpherical, allow_raw_pointers())
      .function("radius", &SphericalDiagram::radius)
      .function("insert", returning<&SphericalDiagram::insert>())
      .function("insertMany", &insertManyOnSphere)
      .function("remove", returning<&SphericalDiagram::remove>())
      .function("removeMany", &removeManyOnSphere)
      .function("update", &updateOnSphere)
      .function("updateMany", &updateManyOnSphere)
      .function("clear", &SphericalDiagram::clear)
      .function("size", &SphericalDiagram::size)
      .function("visibleSize", &SphericalDiagram::visibleSize)
      .function("has", &SphericalDiagram::has)
      .function("site", returning<&SphericalDiagram::site>())
      .function("ids", returning<&SphericalDiagram::ids>())
      .function("sites", returning<&SphericalDiagram::sites>(), moved)
      .function("isHidden", returning<&SphericalDiagram::isHidden>())
      .function("coverOf", &coverOnSphere)
      .function("find", &findOnSphere)
      .function("nearest", &nearestOnSphere)
      .function("findMany", &findManyOnSphere)
      .function("kNearest", returning<&SphericalDiagram::kNearest>())
      .function("nearestFirst", &nearestFirstOnSphere, allow_raw_pointers(), moved)
      .function("neighbors", returning<&SphericalDiagram::neighbors>())
      .function("vertices", returning<&SphericalDiagram::vertices>(), moved)
      .function("edges", returning<&SphericalDiagram::edges>(), moved)
      .function("contains", returning<&SphericalDiagram::contains>())
      .function("cellArea", returning<&SphericalDiagram::cellArea>())
      .function("cellAreas", returning<&SphericalDiagram::cellAreas>())
      .function("cellCentroid", returning<&SphericalDiagram::cellCentroid>())
      .function("cellPolygon", returning<&SphericalDiagram::cellPolygon>(), moved)
      .function("cellPolygons", returning<&SphericalDiagram::cellPolygons>(), moved)
      .function("toBytes", returning<&SphericalDiagram::toBytes>())
      .function("fromBytes", &sphereFromBytes)
      .function("validate", &validateSphere);
}

}  // namespace
