// The functions that adapt the library to Embind, for bindings.cpp: results are returned, errors
// thrown (arrays.h), records come in as numbers one by one, because Embind would leak one if the
// call throws.
#pragma once

#include <emscripten/bind.h>

#include <cmath>
#include <cstdint>
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

/// From which cells a new circle would take something; or, with `isCovered`, what covers it.
struct Conflict {
  std::vector<SiteId> sites;
  bool isCovered = false;
};
Conflict conflict(const Diagram& diagram, double x, double y, double r) {
  Conflict found;
  check(diagram.conflict(x, y, r, found.sites, found.isCovered));
  return found;
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

}  // namespace
