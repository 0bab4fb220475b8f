// Operations of several steps that either succeed or change nothing: if a step lacks memory, the
// steps before it are undone, last one first, each from the state that it had led to. So undoing
// needs the memory that was needed then. Room for large arrays, which grow with a site's
// neighbours, is made step by step (Undo). For small ones, memory is held in reserve and freed
// before undoing.
#pragma once

#include <cstddef>
#include <memory>

#include "diagram/location_index.h"

namespace apollonius::internal {

/// May a step have to be undone? Then it first makes the room for that: undoing needs no memory,
/// and leaves out the levels.
enum class Undo : bool { kNever, kMaybe };

class Transaction {
 public:
  /// Reserves the memory; called before the first step. Throws std::bad_alloc.
  void begin() {
    if (!reserve_) reserve_ = std::make_unique_for_overwrite<std::byte[]>(kReserve);
  }
  /// Undoes the steps by wayBack().
  template <class WayBack>
  void undo(LocationIndex& index, WayBack&& wayBack) noexcept {
    reserve_.reset();
    index.beginUndo();
    wayBack();
    index.endUndo();
  }
  /// Runs steps(). If that throws, wayBack() undoes the steps done, and the exception is rethrown.
  /// REQUIRES: begin().
  template <class Steps, class WayBack>
  void run(LocationIndex& index, Steps&& steps, WayBack&& wayBack) {
    try {
      steps();
    } catch (...) {
      undo(index, wayBack);
      throw;
    }
  }

 private:
  static constexpr std::size_t kReserve = std::size_t{64} * 1024;
  std::unique_ptr<std::byte[]> reserve_;
};

}  // namespace apollonius::internal
