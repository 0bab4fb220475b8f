// A diagram from the bytes of a snapshot, in steps (docs/SNAPSHOTS.md has the format).
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>

#include "base/byte_stream.h"
#include "delaunay/proof.h"
#include "diagram/diagram_core.h"

namespace apollonius::internal {

class Restoring {
 public:
  /// Into a new diagram, which is unusable until all is done. The bytes stay as they are.
  Restoring(DiagramCore& diagram, std::span<const std::uint8_t> bytes, Source source);
  Restoring(const Restoring&) = delete;
  Restoring& operator=(const Restoring&) = delete;

  enum class State : std::uint8_t { kUnderWay, kDone, kCorrupt };

  /// Reads one more part of the bytes, or proves about this many more faces or edges. Throws
  /// std::bad_alloc, and has to be given up then.
  State advance(std::size_t most);
  State finish() {
    State state = State::kUnderWay;
    while (state == State::kUnderWay) state = advance(std::numeric_limits<std::size_t>::max());
    return state;
  }

  /// The share of the work that is done, 0 to 1, as far as time can be foreseen.
  [[nodiscard]] double progress() const;

 private:
  enum class Step : std::uint8_t { kSites, kGraph, kHidden, kProof };
  /// In the order of the bytes, after the magic number.
  struct Header {
    std::uint32_t version, slots, idLimit, sites, hidden, faceSlots;
  };

  [[nodiscard]] bool readSites();
  [[nodiscard]] bool readGraph();
  [[nodiscard]] bool readHidden();

  DiagramCore& diagram_;
  std::span<const std::uint8_t> bytes_;
  Source source_;
  Step step_ = Step::kSites;
  Header header_{};
  WordReader in_;
  std::optional<Proof> proof_;
};

}  // namespace apollonius::internal
