// Included before everything else where mutants are built (switched.mjs): which mutant is on, and
// which ones a run has come by.
#pragma once

#if __cplusplus >= 202002L  // CMake tries the compiler as it is

#include <type_traits>

namespace mutants {

extern int chosen;                       // by APOLLONIUS_MUTANT; -1: none
extern unsigned char isReached[100000];  // written to the file that APOLLONIUS_REACHED names

constexpr bool isOn(int number) {
  if (std::is_constant_evaluated()) return false;
  isReached[number] = 1;
  return number == chosen;
}

}  // namespace mutants

#endif
