// What the module does without of the C++ runtime. Its objects come before the runtime's libraries,
// which then leave theirs out.
#include <cstdlib>
#include <exception>
#include <new>

// Names of the Itanium C++ ABI. Exceptions are only thrown for want of memory, and all are caught
// by `catch (...)`, which asks no type (tests/layers.test.mjs sees to it): so the functions behind
// std::type_info, which follow pointers along base classes, are never called. They would be 1 KB
// with brotli.
extern "C" {
void* _ZTVN10__cxxabiv117__class_type_infoE[4] = {};
void* _ZTVN10__cxxabiv120__si_class_type_infoE[4] = {};

// An exception that nobody catches: no demangled name on a stderr that is not there.
std::terminate_handler __cxa_terminate_handler = std::abort;
std::terminate_handler __cxa_unexpected_handler = std::abort;
std::new_handler __cxa_new_handler = nullptr;
}
