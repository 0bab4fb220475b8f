// A diagram of the sphere from the bytes of a snapshot, in steps (docs/SNAPSHOTS.md has the
// format).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "base/flat_array.h"
#include "diagram/restoring.h"
#include "sphere/projected_diagram.h"
#include "sphere/spherical_core.h"

namespace apollonius::internal::sphere {

class Restoring {
 public:
  using State = internal::Restoring::State;

  /// Into a new diagram, which is unusable until all is done, and gets the radius that was saved.
  /// The bytes stay as they are.
  Restoring(SphericalCore& diagram, std::span<const std::uint8_t> bytes)
      : diagram_(diagram), bytes_(bytes) {}
  Restoring(const Restoring&) = delete;
  Restoring& operator=(const Restoring&) = delete;

  /// Reads the bytes, or goes on building by about `steps`, of about a microsecond each. Throws
  /// std::bad_alloc, and has to be given up then.
  State advance(std::size_t steps);
  State finish() {
    State state = State::kUnderWay;
    while (state == State::kUnderWay) state = advance(BulkInsertion::kAllAtOnce);
    return state;
  }

  /// The share of the work that is done, 0 to 1, as far as time can be foreseen.
  [[nodiscard]] double progress() const;

 private:
  enum class Step : std::uint8_t { kRead, kFill, kHide };

  [[nodiscard]] bool read();
  [[nodiscard]] bool beginToFill(SiteId pole);
  [[nodiscard]] bool hide();

  SphericalCore& diagram_;
  std::span<const std::uint8_t> bytes_;
  Step step_ = Step::kRead;
  FlatArray<HiddenSite> hidden_;
  FlatArray<Cap> caps_;  // by id
  std::optional<ProjectedDiagram::Filling> filling_;
};

}  // namespace apollonius::internal::sphere
