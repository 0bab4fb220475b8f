// How errors and arrays pass between C++ and JavaScript. A call that fails throws the number of its
// Error. Arrays are copied in both directions: a view of the memory dies when the memory grows.
#pragma once

#include <emscripten/bind.h>
#include <emscripten/val.h>

#include <cstdint>
#include <new>
#include <stdexcept>
#include <type_traits>
#include <vector>

#include "apollonius/diagram.h"

EMSCRIPTEN_DECLARE_VAL_TYPE(Uint8Array)
EMSCRIPTEN_DECLARE_VAL_TYPE(Int32Array)
EMSCRIPTEN_DECLARE_VAL_TYPE(Uint32Array)
EMSCRIPTEN_DECLARE_VAL_TYPE(Float64Array)
EMSCRIPTEN_DECLARE_VAL_TYPE(NumbersIn)   // a typed array of any kind
EMSCRIPTEN_DECLARE_VAL_TYPE(NumbersOut)  // a typed array that is filled, or null

/// Returns a copy of a view, or null if JavaScript has no room for it, without a trap
/// (embind_parts.js).
extern "C" emscripten::EM_VAL copied(emscripten::EM_VAL view);

[[noreturn]] inline void fail(apollonius::Error error) {
  emscripten::val(static_cast<int>(error)).throw_();
}

inline void check(apollonius::Error error) {
  if (error != apollonius::Error::kNone) fail(error);
}

/// Returns the result of an operation that allocates; throws a lack of memory as an Error.
template <class Operation>
auto allocating(Operation&& operation) {
  try {
    return operation();
  } catch (const std::bad_alloc&) {
  } catch (const std::length_error&) {
  }
  fail(apollonius::Error::kOutOfMemory);
}

template <class T>
emscripten::val viewOf(const std::vector<T>& values) {
  return emscripten::val(emscripten::typed_memory_view(values.size(), values.data()));
}

template <class T>
std::vector<T> vectorOf(const emscripten::val& array) {
  auto values =
      allocating([&] { return std::vector<T>(array["length"].template as<std::size_t>()); });
  viewOf(values).template call<void>("set", array);
  return values;
}

template <class T>
struct TypedArrayOf;
template <>
struct TypedArrayOf<std::uint8_t> : std::type_identity<Uint8Array> {};
template <>
struct TypedArrayOf<std::int32_t> : std::type_identity<Int32Array> {};
template <>
struct TypedArrayOf<std::uint32_t> : std::type_identity<Uint32Array> {};
template <>
struct TypedArrayOf<double> : std::type_identity<Float64Array> {};

/// A vector goes out as a typed array.
namespace emscripten::internal {
template <class T>
struct TypeID<std::vector<T>> : TypeID<typename TypedArrayOf<T>::type> {};
template <class T>
struct BindingType<std::vector<T>> {
  using WireType = BindingType<val>::WireType;
  static WireType toWireType(const std::vector<T>& values, rvp::default_tag tag) {
    const EM_VAL copy = copied(viewOf(values).as_handle());
    if (copy == nullptr) fail(apollonius::Error::kOutOfMemory);
    return BindingType<val>::toWireType(val::take_ownership(copy), tag);
  }
  static std::vector<T> fromWireType(WireType array) {
    return vectorOf<T>(BindingType<val>::fromWireType(array));
  }
};
}  // namespace emscripten::internal
