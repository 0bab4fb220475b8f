#include "sphere/pole_choice.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/flat_array.h"
#include "sphere/projection.h"

namespace apollonius::internal {

namespace {

constexpr int kCandidates = 8;

/// Knuth's generator of 64 bits (MMIX), of which the upper half is used.
std::uint32_t draw(std::uint64_t& seed, std::uint64_t limit) {
  seed = seed * 6364136223846793005u + 1442695040888963407u;
  return static_cast<std::uint32_t>((seed >> 32) * limit >> 32);
}

struct Candidate {
  SiteId id = kNoSite;
  Cap cap;
};

/// The largest loss of accuracy of a circle that is seen from a pole.
double lossFrom(const Cap& pole, const FlatArray<Candidate>& sites) {
  const Projection projection(pole);
  double loss = 1;
  for (const Candidate& site : sites) {
    const Projection::Image image = projection.image(site.cap);
    if (image.kind == Projection::Kind::kCoversPole) return std::numeric_limits<double>::infinity();
    if (image.kind == Projection::Kind::kCircle) loss = std::max(loss, image.loss);
  }
  return loss;
}

}  // namespace

SiteId choosePole(const SiteTable& sites, std::uint64_t& seed) {
  FlatArray<Candidate> all;
  all.reserve(sites.size());
  for (SiteId id = 0; id < sites.idLimit(); ++id) {
    if (sites.has(id)) all.push_back({id, sites.cap(id)});
  }
  SiteId best = kNoSite;
  double least = 0;
  for (int k = 0; k < kCandidates && (best == kNoSite || least > kUsualLoss); ++k) {
    // The site that is nearest to a centre is visible: paper, Lemma 1, which needs the triangle
    // inequality only. Of equally near ones the heaviest is.
    const Candidate& drawn = all[draw(seed, all.size())];
    const Candidate* nearest = &drawn;
    HalfAngle toNearest = distance(drawn.cap.centre, drawn.cap);
    for (const Candidate& site : all) {
      const HalfAngle toSite = distance(drawn.cap.centre, site.cap);
      if (toSite < toNearest || (!(toNearest < toSite) && nearest->cap.weight < site.cap.weight)) {
        nearest = &site;
        toNearest = toSite;
      }
    }
    const double loss = lossFrom(nearest->cap, all);
    if (best == kNoSite || loss < least) {
      best = nearest->id;
      least = loss;
    }
  }
  return best;
}

bool isVisible(const SiteTable& sites, SiteId id) {
  const Projection projection(sites.cap(id));
  for (SiteId other = 0; other < sites.idLimit(); ++other) {
    if (sites.has(other) && other != id &&
        projection.image(sites.cap(other)).kind == Projection::Kind::kCoversPole)
      return false;
  }
  return true;
}

}  // namespace apollonius::internal
