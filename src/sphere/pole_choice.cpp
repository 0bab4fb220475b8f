#include "sphere/pole_choice.h"

#include <algorithm>
#include <limits>
#include <numbers>
#include <utility>

#include "base/flat_array.h"
#include "sphere/projection.h"

namespace apollonius::internal::sphere {

namespace {

constexpr int kCandidates = 8;
/// With such a loss a circle is within no more than 10^-7 radians of its cap.
constexpr double kRough = 0x1p30;

/// Knuth's generator of 64 bits (MMIX), of which the upper half is used.
std::uint32_t draw(std::uint64_t& seed, std::uint64_t limit) {
  seed = seed * 6364136223846793005u + 1442695040888963407u;
  return static_cast<std::uint32_t>((seed >> 32) * limit >> 32);
}

/// The largest loss of accuracy of a circle that is seen from a pole.
double lossFrom(const Cap& pole, const FlatArray<SiteId>& sites, const FlatArray<Cap>& caps) {
  const Projection projection(pole);
  double loss = 1;
  for (const SiteId id : sites) {
    const Projection::Image image = projection.image(caps[id]);
    if (image.kind == Projection::Kind::kCoversPole) return std::numeric_limits<double>::infinity();
    if (image.kind == Projection::Kind::kCircle) loss = std::max(loss, image.loss);
  }
  return loss;
}

}  // namespace

SiteId choosePole(const SiteTable& sites, const FlatArray<Cap>& caps, std::uint64_t& seed) {
  FlatArray<SiteId> all;
  all.reserve(sites.size());
  for (SiteId id = 0; id < sites.idLimit(); ++id) {
    if (sites.has(id)) all.push_back(id);
  }
  SiteId best = kNoSite;
  double least = 0;
  FlatArray<SiteId> starts = all;  // what leads to a candidate, which is not to be the same again
  for (int k = 0; k < kCandidates && !starts.empty(); ++k) {
    // The site that is nearest to a centre is visible: paper, Lemma 1, which needs the triangle
    // inequality only. Of equally near ones the heaviest is.
    const SiteId start = starts[draw(seed, starts.size())];
    SiteId nearest = start;
    const Direction centre = caps[nearest].centre;
    HalfAngle toNearest = distance(centre, caps[nearest]);
    for (const SiteId id : all) {
      // Half a turn is more than any angle makes up for; the others' distances can be compared, as
      // those that are at least -pi are, with one that is below pi.
      const double heavier = caps[id].weight - caps[nearest].weight;
      if (heavier <= -std::numbers::pi) continue;
      const HalfAngle toSite = distance(centre, caps[id]);
      if (toSite < toNearest || (!(toNearest < toSite) && heavier > 0)) {
        nearest = id;
        toNearest = toSite;
      }
    }
    const double loss = lossFrom(caps[nearest], all, caps);
    // Where one nearly covers another, the circle of either is of no use as seen from the other.
    // The one that nearly covers is the pole then: what is lost is a cell of nearly no width.
    const bool areRough = best != kNoSite && std::min(loss, least) > kRough;
    const bool isBetter = areRough ? caps[nearest].weight > caps[best].weight : loss < least;
    if (best == kNoSite || isBetter) {
      best = nearest;
      least = loss;
    }
    if (least <= kUsualLoss) break;
    const Projection projection(caps[nearest]);
    std::size_t kept = 0;
    for (const SiteId id : starts) {
      if (id != start && projection.image(caps[id]).kind != Projection::Kind::kBelowPole)
        starts[kept++] = id;
    }
    starts.resize(kept);
  }
  return best;
}

}  // namespace apollonius::internal::sphere
