// Choice of the pole, the site that the others are projected from.
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/flat_array.h"
#include "sphere/projection.h"
#include "sphere/site_table.h"

namespace apollonius::internal::sphere {

/// Chooses, in steps, a visible site from which circles lose little accuracy: of a few random ones,
/// the first from which the loss (Projection::Image) is usual, else the best. Cost: O(n)
class PoleChoice {
 public:
  /// Chooses among the sites of the table; `caps` are theirs by id. Both must stay as they are.
  /// Advances `seed`, which must stay where it is. Throws std::bad_alloc. REQUIRES: at least one
  /// site.
  PoleChoice(const SiteTable& sites, const FlatArray<Cap>& caps, std::uint64_t& seed);

  /// Goes on by at most this many steps of one site each. True if the pole is chosen.
  bool advance(std::size_t most);

  /// The chosen site. REQUIRES: chosen.
  [[nodiscard]] SiteId pole() const { return best_; }

 private:
  enum class Step : std::uint8_t { kNearest, kLoss, kStarts, kChosen };

  void draw();
  void lookForNearest(std::size_t end);
  void lookForLoss(std::size_t end);
  void dropStarts(std::size_t end);
  [[nodiscard]] bool isBetter() const;

  const FlatArray<Cap>& caps_;
  std::uint64_t& seed_;
  FlatArray<SiteId> all_;
  FlatArray<SiteId> starts_;  // sites that can lead to another candidate than those tried
  int drawn_ = 0;             // number of candidates drawn
  Step step_ = Step::kNearest;
  std::size_t at_ = 0;  // index in all_ or starts_

  SiteId start_ = kNoSite;    // the one that leads to the candidate
  SiteId nearest_ = kNoSite;  // the site nearest to the centre of start_: the candidate
  HalfAngle toNearest_;
  Projection projection_;  // from the candidate
  double loss_ = 0;        // from the candidate
  std::size_t kept_ = 0;   // number of starts_ kept

  SiteId best_ = kNoSite;
  double least_ = 0;  // the loss from best_
};

}  // namespace apollonius::internal::sphere
