// Functions that adapt the library to Embind, shared by the bindings of all parts. They return
// results and throw errors (arrays.h). They take a record as separate numbers, because Embind would
// leak a record if the call throws.
#pragma once

#include <emscripten/bind.h>

#include <cstdint>
#include <memory>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "apollonius/diagram.h"
#include "arrays.h"

using apollonius::Error;
using apollonius::SiteId;
using apollonius::Source;
using apollonius::Top;
using emscripten::val;

// `AnyDiagram` is a Diagram or a SphericalDiagram.

template <std::size_t k, class... Types>
using Nth = std::tuple_element_t<k, std::tuple<Types...>>;

/// Returns -1 for kNoSite.
inline std::int32_t asSigned(SiteId id) { return static_cast<std::int32_t>(id); }

/// Turns the method `Error method(in..., Out& out)` into a function of the object and `in` that
/// returns `out`; an id as asSigned() does.
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

struct Nearest {
  std::int32_t id = -1;
  double distance = 0;
};
template <class AnyDiagram>
Nearest nearest(const AnyDiagram& diagram, double x, double y, double maxDistance) {
  SiteId id = apollonius::kNoSite;
  double distance = 0;
  check(diagram.find(x, y, maxDistance, id, distance));
  return {asSigned(id), distance};
}
template <class AnyDiagram>
std::int32_t find(const AnyDiagram& diagram, double x, double y) {
  SiteId id = apollonius::kNoSite;
  check(diagram.find(x, y, id));
  return asSigned(id);
}
template <class AnyDiagram>
std::int32_t findWithin(const AnyDiagram& diagram, double x, double y, double maxDistance) {
  SiteId id = apollonius::kNoSite;
  check(diagram.find(x, y, maxDistance, id));
  return asSigned(id);
}

template <class AnyDiagram>
Nearest farthest(const AnyDiagram& diagram, double x, double y) {
  SiteId id = apollonius::kNoSite;
  double distance = 0;
  check(diagram.farthest(x, y, id, distance));
  return {asSigned(id), distance};
}

template <class AnyDiagram>
std::vector<SiteId> kNearest(const AnyDiagram& diagram, double x, double y, std::size_t k,
                             double maxDistance) {
  std::vector<SiteId> sites;
  check(diagram.kNearest(x, y, k, maxDistance, sites));
  return sites;
}

template <class AnyDiagram>
apollonius::NearbyLists kNearestMany(const AnyDiagram& diagram, const NumbersIn& xy, std::size_t k,
                                     double maxDistance, bool withDistances) {
  apollonius::NearbyLists lists;
  check(diagram.kNearestMany(vectorOf<double>(xy), k, maxDistance, withDistances, lists));
  return lists;
}

/// The caller deletes it, before the diagram changes.
template <class Walk, class AnyDiagram>
Walk* nearestFirst(const AnyDiagram& diagram, double x, double y, double maxDistance) {
  auto walk = allocating([&] { return std::make_unique<Walk>(diagram); });
  check(walk->start(x, y, maxDistance));
  return walk.release();
}

template <class AnyDiagram>
void update(AnyDiagram& diagram, SiteId id, double x, double y, double r) {
  check(diagram.update(id, x, y, r));
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
void findMany(const AnyDiagram& diagram, const NumbersIn& xy, double maxDistance,
              const NumbersOut& ids, const NumbersOut& distances) {
  const std::vector<double> points = vectorOf<double>(xy);
  const std::size_t count = points.size() / 2;
  auto found = allocating([&] { return std::vector<SiteId>(count); });
  auto far = allocating([&] { return std::vector<double>(distances.isNull() ? 0 : count); });
  check(diagram.findMany(points, maxDistance, found, far));
  ids.call<void>("set", viewOf(found));
  if (!distances.isNull()) distances.call<void>("set", viewOf(far));
}

template <class AnyDiagram>
double revision(const AnyDiagram& diagram) {
  return static_cast<double>(diagram.revision());
}

// --- Building in steps. These are calls of the diagram: a trap in one of them breaks the diagram.

/// The caller deletes it, before the diagram.
template <class AnyBuilder, class AnyDiagram>
AnyBuilder* builder(AnyDiagram& diagram, std::size_t count) {
  auto made = allocating([&] { return std::make_unique<AnyBuilder>(diagram); });
  check(made->reserve(count));
  return made.release();
}

template <class AnyBuilder, class AnyDiagram>
void addTo(AnyDiagram&, AnyBuilder& builder, const NumbersIn& sites) {
  check(builder.add(vectorOf<double>(sites)));
}

template <class AnyBuilder, class AnyDiagram>
void readInto(AnyDiagram&, AnyBuilder& builder, const NumbersIn& bytes, bool isTrusted) {
  const Source source = isTrusted ? Source::kTrusted : Source::kAnyone;
  check(builder.read(vectorOf<std::uint8_t>(bytes), source));
}

/// Does up to `steps` steps. Is the building done?
template <class AnyBuilder, class AnyDiagram>
bool advance(AnyDiagram&, AnyBuilder& builder, std::size_t steps) {
  bool isDone = false;
  check(builder.advance(steps, isDone));
  return isDone;
}

// ---

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

/// Is the topmost circle the last one inserted, or the smallest?
template <class AnyDiagram>
std::int32_t pick(const AnyDiagram& diagram, double x, double y, double maxDistance, bool isLast) {
  SiteId id = apollonius::kNoSite;
  check(diagram.pick(x, y, maxDistance, isLast ? Top::kLast : Top::kSmallest, id));
  return asSigned(id);
}

/// Registers the calls of a first insertion and query, which both kinds of diagrams have.
template <class AnyDiagram>
emscripten::class_<AnyDiagram> registerDiagram(const char* name) {
  return emscripten::class_<AnyDiagram>(name)
      .function("insert", returning<&AnyDiagram::insert>())
      .function("size", &AnyDiagram::size)
      .function("find", &find<AnyDiagram>)
      .function("findWithin", &findWithin<AnyDiagram>)
      .function("nearest", &nearest<AnyDiagram>)
      .function("pick", &pick<AnyDiagram>);
}

/// The other calls that both kinds of diagrams have; `Walk` is the class of their nearestFirst().
template <class Walk, class AnyBuilder, class AnyDiagram>
void registerOthers(const emscripten::class_<AnyDiagram>& diagram, const char* nameOfWalk,
                    const char* nameOfBuilder) {
  using namespace emscripten;
  const return_value_policy::take_ownership moved;  // not copied
  class_<Walk>(nameOfWalk)
      .function("next", returning<&Walk::next>())
      .function("distance", &Walk::distance);
  class_<AnyBuilder>(nameOfBuilder).function("progress", &AnyBuilder::progress);
  diagram
      // Sites
      .function("remove", returning<&AnyDiagram::remove>())
      .function("removeMany", &removeMany<AnyDiagram>)
      .function("update", &update<AnyDiagram>)
      .function("updateMany", &updateMany<AnyDiagram>)
      .function("clear", &AnyDiagram::clear)
      .function("builder", &builder<AnyBuilder, AnyDiagram>, allow_raw_pointers(), moved)
      .function("addTo", &addTo<AnyBuilder, AnyDiagram>)
      .function("readInto", &readInto<AnyBuilder, AnyDiagram>)
      .function("advance", &advance<AnyBuilder, AnyDiagram>)
      .function("visibleSize", &AnyDiagram::visibleSize)
      .function("has", &AnyDiagram::has)
      .function("idLimit", &AnyDiagram::idLimit)
      .function("site", returning<&AnyDiagram::site>())
      .function("ids", returning<&AnyDiagram::ids>())
      .function("sites", returning<&AnyDiagram::sites>(), moved)
      .function("isHidden", returning<&AnyDiagram::isHidden>())
      .function("coverOf", returning<&AnyDiagram::coverOf>())
      // Queries
      .function("farthest", &farthest<AnyDiagram>)
      .function("findMany", &findMany<AnyDiagram>)
      .function("kNearest", &kNearest<AnyDiagram>)
      .function("kNearestMany", &kNearestMany<AnyDiagram>)
      .function("nearestFirst", &nearestFirst<Walk, AnyDiagram>, allow_raw_pointers(), moved)
      .function("neighbors", returning<&AnyDiagram::neighbors>())
      .function("vertices", returning<&AnyDiagram::vertices>(), moved)
      .function("edges", returning<&AnyDiagram::edges>(), moved)
      .function("revision", &revision<AnyDiagram>)
      .function("toBytes", returning<&AnyDiagram::toBytes>())
      .function("validate", &validate<AnyDiagram>);
}
