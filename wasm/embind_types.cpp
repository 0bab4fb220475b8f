// Embind's registry with the few types that wasm/bindings.cpp uses. Emscripten's own (libembind's bind.cpp, in whose place the
// linker takes this file) registers strings of all widths, 64-bit integers, floats and memory views as well, and with them comes
// the JavaScript that converts them: a third of the glue, and more than the library's own TypeScript.
#include <emscripten/bind.h>

#include <cstring>
#include <limits>
#include <typeinfo>

namespace {

emscripten::internal::InitFunc* firstBindings = nullptr;

template <class Integer>
void registerInteger(const char* name) {
  using namespace emscripten::internal;
  _embind_register_integer(TypeID<Integer>::get(), name, sizeof(Integer), std::numeric_limits<Integer>::min(),
                           std::numeric_limits<Integer>::max());
}

}  // namespace

extern "C" {

// Called by embind's JavaScript for the name of a type that is not registered; JavaScript frees it.
const char* __getTypeName(const std::type_info* type) { return strdup(type->name()); }

void _embind_register_bindings(emscripten::internal::InitFunc* bindings) {
  bindings->next = firstBindings;
  firstBindings = bindings;
}

void _embind_initialize_bindings() {
  for (auto* bindings = firstBindings; bindings != nullptr; bindings = bindings->next) bindings->init_func();
}

}  // extern "C"

EMSCRIPTEN_BINDINGS(types) {
  using namespace emscripten::internal;
  _embind_register_void(TypeID<void>::get(), "void");
  _embind_register_bool(TypeID<bool>::get(), "bool", true, false);
  registerInteger<int>("int");
  registerInteger<unsigned int>("unsigned int");
  registerInteger<unsigned long>("unsigned long");  // std::size_t and addresses
}
