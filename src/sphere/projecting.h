// The projection of all sites of a table, from a pole that is chosen for them, in steps.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "base/flat_array.h"
#include "sphere/pole_choice.h"
#include "sphere/projected_diagram.h"
#include "sphere/site_table.h"

namespace apollonius::internal::sphere {

class Projecting {
 public:
  /// The table must stay as it is; `seed` is for drawing poles. Throws std::bad_alloc. REQUIRES: at
  /// least one site.
  Projecting(const SiteTable& sites, std::uint64_t seed);
  Projecting(const Projecting&) = delete;
  Projecting& operator=(const Projecting&) = delete;

  /// Goes on by about `steps`, of about a microsecond each; is that all? Throws std::bad_alloc, and
  /// has to be given up then. Cost, of all: that of building a diagram of the plane.
  bool advance(std::size_t steps);
  void finish() {
    while (!advance(BulkInsertion::kAllAtOnce)) {
    }
  }

  /// Of all that there is to do, 0 to 1, as far as time can be foreseen. Never falls.
  [[nodiscard]] double progress() const { return progress_; }

  /// What has been made. REQUIRES: finished.
  [[nodiscard]] ProjectedDiagram& diagram() { return diagram_; }
  /// For drawing the next pole.
  [[nodiscard]] std::uint64_t seed() const { return seed_; }

 private:
  enum class Step : std::uint8_t { kCaps, kPole, kFill };

  void makeCaps(std::size_t most);
  void beginToFill();

  const SiteTable& sites_;
  std::uint64_t seed_;
  FlatArray<Cap> caps_;  // by id
  Step step_ = Step::kCaps;
  SiteId next_ = 0;  // whose cap is made next
  int poles_ = 0;    // that have been tried
  double progress_ = 0;
  std::optional<PoleChoice> choice_;
  ProjectedDiagram diagram_;
  std::optional<ProjectedDiagram::Filling> filling_;  // of diagram_
};

}  // namespace apollonius::internal::sphere
