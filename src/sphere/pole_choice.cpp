#include "sphere/pole_choice.h"

#include <algorithm>
#include <limits>
#include <numbers>

namespace apollonius::internal::sphere {

namespace {

using Kind = Projection::Kind;

constexpr int kCandidates = 8;
/// With such a loss a circle is within no more than 10^-7 radians of its cap.
constexpr double kRough = 0x1p30;

/// Knuth's generator of 64 bits (MMIX), of which the upper half is used.
std::uint32_t drawBelow(std::uint64_t limit, std::uint64_t& seed) {
  seed = seed * 6364136223846793005u + 1442695040888963407u;
  return static_cast<std::uint32_t>((seed >> 32) * limit >> 32);
}

}  // namespace

PoleChoice::PoleChoice(const SiteTable& sites, const FlatArray<Cap>& caps, std::uint64_t& seed)
    : caps_(caps), seed_(seed) {
  all_.reserve(sites.size());
  for (SiteId id = 0; id < sites.idLimit(); ++id) {
    if (sites.has(id)) all_.push_back(id);
  }
  starts_ = all_;
  draw();
}

void PoleChoice::draw() {
  start_ = nearest_ = starts_[drawBelow(starts_.size(), seed_)];
  toNearest_ = distance(caps_[start_].centre, caps_[start_]);
  ++drawn_;
  step_ = Step::kNearest;
  at_ = 0;
}

bool PoleChoice::advance(std::size_t most) {
  const std::size_t size = step_ == Step::kStarts ? starts_.size() : all_.size();
  const std::size_t end = at_ + std::min(most, size - at_);
  switch (step_) {
    case Step::kNearest:
      lookForNearest(end);
      if (at_ < size) return false;
      projection_ = Projection(caps_[nearest_]);
      loss_ = 1;
      at_ = 0;
      step_ = Step::kLoss;
      return false;
    case Step::kLoss:
      lookForLoss(end);
      if (at_ < size) return false;
      if (best_ == kNoSite || isBetter()) {
        best_ = nearest_;
        least_ = loss_;
      }
      at_ = kept_ = 0;
      step_ = least_ <= kUsualLoss || drawn_ == kCandidates ? Step::kChosen : Step::kStarts;
      return step_ == Step::kChosen;
    case Step::kStarts:
      dropStarts(end);
      if (at_ < size) return false;
      starts_.resize(kept_);
      if (kept_ > 0)
        draw();
      else
        step_ = Step::kChosen;
      return step_ == Step::kChosen;
    case Step::kChosen:
      return true;
  }
  return true;
}

/// Searches for the site nearest to a centre. It is visible: paper, Lemma 1, which needs only the
/// triangle inequality. Among equally near ones the heaviest is visible.
void PoleChoice::lookForNearest(std::size_t end) {
  const Direction centre = caps_[start_].centre;
  for (; at_ < end; ++at_) {
    const SiteId id = all_[at_];
    // No angle makes up for a weight that is less by half a turn. The other distances can be
    // compared: they are at least -pi, and the one compared with is below pi.
    const double heavier = caps_[id].weight - caps_[nearest_].weight;
    if (heavier <= -std::numbers::pi) continue;
    const HalfAngle toSite = distance(centre, caps_[id]);
    if (toSite < toNearest_ || (!(toNearest_ < toSite) && heavier > 0)) {
      nearest_ = id;
      toNearest_ = toSite;
    }
  }
}

/// Finds the largest loss of accuracy of a circle projected from the candidate.
void PoleChoice::lookForLoss(std::size_t end) {
  for (; at_ < end; ++at_) {
    const Projection::Image image = projection_.image(caps_[all_[at_]]);
    if (image.kind == Kind::kCoversPole) {
      loss_ = std::numeric_limits<double>::infinity();
      at_ = all_.size();
      return;
    }
    if (image.kind == Kind::kCircle) loss_ = std::max(loss_, image.loss);
  }
}

/// Is the candidate better than the best one so far?
bool PoleChoice::isBetter() const {
  // If one site nearly covers another, neither has an accurate circle when projected from the
  // other. Then the one that nearly covers becomes the pole: only a cell of nearly no width is
  // lost.
  const bool areRough = std::min(loss_, least_) > kRough;
  return areRough ? caps_[nearest_].weight > caps_[best_].weight : loss_ < least_;
}

/// Drops the starts that the candidate covers: they would lead to it again.
void PoleChoice::dropStarts(std::size_t end) {
  for (; at_ < end; ++at_) {
    const SiteId id = starts_[at_];
    if (id != start_ && projection_.image(caps_[id]).kind != Kind::kBelowPole)
      starts_[kept_++] = id;
  }
}

}  // namespace apollonius::internal::sphere
