#include "sphere/projecting.h"

#include <algorithm>
#include <utility>

namespace apollonius::internal::sphere {

namespace {

/// A pole with more neighbours than this is expensive to ask, and another one is tried: of the
/// visible sites fewer than one in ten has 64 neighbours or more, as they have six on average.
constexpr std::size_t kMostNeighborsOfPole = 64;
constexpr int kPoles = 4;

bool hasManyNeighbors(const Graph& graph) {
  if (graph.isEmpty()) return false;
  std::size_t neighbors = 0;
  for (const HalfedgeId h : graph.star(kInfinity)) {
    static_cast<void>(h);
    if (++neighbors > kMostNeighborsOfPole) return true;
  }
  return false;
}

}  // namespace

Projecting::Projecting(const SiteTable& sites, std::uint64_t seed)
    : sites_(sites), seed_(seed), caps_(sites.idLimit()) {}

bool Projecting::advance(std::size_t steps) {
  switch (step_) {
    case Step::kCaps:
      makeCaps(BulkInsertion::visits(steps, 8));
      return false;
    case Step::kPole:
      if (choice_->advance(BulkInsertion::visits(steps, 32))) beginToFill();
      return false;
    case Step::kFill:
      if (!filling_->advance(steps)) {
        progress_ = std::max(progress_, 0.1 + 0.9 * filling_->progress());
        return false;
      }
      filling_.reset();
      if (++poles_ == kPoles || !hasManyNeighbors(diagram_.graph())) {
        progress_ = 1;
        return true;
      }
      choice_.emplace(sites_, caps_, seed_);
      step_ = Step::kPole;
      return false;
  }
  return true;
}

void Projecting::makeCaps(std::size_t most) {
  const SiteId limit = sites_.idLimit();
  const auto end = static_cast<SiteId>(next_ + std::min<std::size_t>(most, limit - next_));
  for (; next_ < end; ++next_) {
    if (sites_.has(next_)) caps_[next_] = sites_.cap(next_);
  }
  progress_ = 0.05 * next_ / limit;
  if (next_ < limit) return;
  choice_.emplace(sites_, caps_, seed_);
  step_ = Step::kPole;
}

void Projecting::beginToFill() {
  SiteId pole = choice_->pole();
  choice_.reset();
  // The pole is visible, so no identical site has a lesser id.
  for (SiteId id = 0; id < pole; ++id) {
    if (sites_.has(id) && areIdentical(caps_[id], caps_[pole])) pole = id;
  }
  FlatArray<SiteId> others;
  others.reserve(sites_.size());
  for (SiteId id = 0; id < sites_.idLimit(); ++id) {
    if (sites_.has(id) && id != pole) others.push_back(id);
  }
  diagram_ = ProjectedDiagram(caps_[pole], pole);
  filling_.emplace(diagram_, sites_, caps_, std::move(others));
  step_ = Step::kFill;
}

}  // namespace apollonius::internal::sphere
