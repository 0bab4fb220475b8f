// Array: the arrays that the library's users get, which are std::vector. Only the wasm module,
// where nobody but its own bindings reads them, is compiled without the code of std::vector
// (WasmModule.cmake).
#pragma once

#include <span>

#ifdef APOLLONIUS_FLAT_ARRAYS
#include "memory/flat_array.h"
#else
#include <vector>
#endif

namespace apollonius {

#ifdef APOLLONIUS_FLAT_ARRAYS
template <class T>
using Array = FlatArray<T>;
inline void append(Array<double>& array, std::span<const double> values) { array.append(values); }
#else
template <class T>
using Array = std::vector<T>;
inline void append(Array<double>& array, std::span<const double> values) {
  array.insert(array.end(), values.begin(), values.end());
}
#endif

}  // namespace apollonius
