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

  /// Goes on by about `steps`, of about a microsecond each. True if all is done. Throws
  /// std::bad_alloc, and has to be given up then. Total cost: that of building a diagram of the
  /// plane.
  bool advance(std::size_t steps);
  void finish() {
    while (!advance(BulkInsertion::kAllAtOnce)) {
    }
  }

  /// The share of the work that is done, 0 to 1, by estimated time. Never falls.
  [[nodiscard]] double progress() const { return progress_; }

  /// The diagram made. REQUIRES: finished.
  [[nodiscard]] ProjectedDiagram& diagram() { return diagram_; }
  /// The seed for choosing the next pole.
  [[nodiscard]] std::uint64_t seed() const { return seed_; }

 private:
  enum class Step : std::uint8_t { kCaps, kPole, kFill };

  void makeCaps(std::size_t most);
  void beginToFill();

  const SiteTable& sites_;
  std::uint64_t seed_;
  FlatArray<Cap> caps_;  // by id
  Step step_ = Step::kCaps;
  SiteId next_ = 0;  // the site whose cap is made next
  int poles_ = 0;    // number of poles tried
  double progress_ = 0;
  std::optional<PoleChoice> choice_;
  ProjectedDiagram diagram_;
  std::optional<ProjectedDiagram::Filling> filling_;  // fills diagram_
};

}  // namespace apollonius::internal::sphere
