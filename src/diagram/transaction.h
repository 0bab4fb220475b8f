// Operations of several steps that either succeed or change nothing: should a step lack memory,
// those before are undone, last one first, each from what it had led to. So undoing needs what was
// needed then. Room for the large things, which grow with a site's neighbours, is made step by step
// (Undo). For the small ones, memory is held back, which is given back first.
#pragma once

#include <cstddef>
#include <memory>

#include "diagram/location_index.h"

namespace apollonius::internal {

/// May a step have to be undone? Then it first makes the room that takes: undoing needs no memory,
/// and the levels are left out of it.
enum class Undo : bool { kNever, kMaybe };

class Transaction {
 public:
  /// Before the first step: holds the memory back. Throws std::bad_alloc.
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
  /// Runs steps(). If that throws, wayBack() undoes what has been done, and it is thrown on.
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
