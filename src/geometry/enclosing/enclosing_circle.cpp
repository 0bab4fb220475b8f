#include "geometry/enclosing/enclosing_circle.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "base/flat_array.h"
#include "base/radix_sort.h"
#include "diagram/listing.h"
#include "geometry/enclosing/enclosure.h"
#include "number/invariant.h"

namespace apollonius::internal {

namespace {

bool holdsAll(const Enclosure& circle, std::span<const Site> sites) {
  return std::all_of(sites.begin(), sites.end(),
                     [&](const Site& s) { return circle.holds(s) != Sign::kNegative; });
}

/// Is the smallest circle around three sites that around two of them?
bool isDeterminedByTwo(const std::array<Site, 3>& three) {
  return holdsAll({three[0], three[1]}, three) || holdsAll({three[1], three[2]}, three) ||
         holdsAll({three[0], three[2]}, three);
}

/// The smallest circle around two to four sites, none of which covers another. REQUIRES: the first
/// one touches it.
Enclosure around(std::span<const Site> sites) {
  for (std::size_t b = 1; b < sites.size(); ++b) {
    const Enclosure circle(sites[0], sites[b]);
    if (holdsAll(circle, sites)) return circle;
  }
  for (std::size_t c = 2; c < sites.size(); ++c) {
    for (std::size_t b = 1; b < c; ++b) {
      const std::array<Site, 3> three{sites[0], sites[b], sites[c]};
      if (isDeterminedByTwo(three)) continue;
      const Enclosure circle(three[0], three[1], three[2]);
      if (holdsAll(circle, sites)) return circle;
    }
  }
  invariant(false, "a few circles have a smallest one around them");
  return {sites[0], sites[1]};
}

/// Up to four sites, each once.
class Few {
 public:
  explicit Few(const Site& first) : sites_{first} {}

  void add(const Site& site) {
    const auto isSame = [&](const Site& s) {
      return s.x == site.x && s.y == site.y && s.r == site.r;
    };
    if (std::none_of(sites_.begin(), sites_.begin() + count_, isSame)) sites_[count_++] = site;
  }
  void add(const Enclosure& circle) {
    for (std::size_t k = 0; k < circle.size(); ++k) add(circle.site(k));
  }
  [[nodiscard]] std::span<const Site> all() const { return {sites_.data(), count_}; }

 private:
  std::array<Site, 4> sites_;
  std::size_t count_ = 1;
};

/// The circle that all of these touch from inside, determined by the same sites whichever `found`
/// is of: if more than two touch it, by the lightest one and two others around its centre.
Enclosure canonical(const Enclosure& found, std::span<const Site> touching) {
  if (touching.size() == 2) return {touching[0], touching[1]};
  Few few(*std::max_element(touching.begin(), touching.end(), [](const Site& a, const Site& b) {
    return precedes(opposite(a), opposite(b));
  }));
  few.add(found);
  for (std::size_t k = 0; few.all().size() < 3; ++k) few.add(touching[k]);
  // `found` is of the lightest one and two others, or of two.
  if (few.all().size() == 3) return {few.all()[0], few.all()[1], few.all()[2]};
  const Enclosure circle = around(few.all());
  if (circle.size() == 3) return circle;
  Few three(circle.site(0));
  three.add(circle.site(1));
  for (std::size_t k = 0; three.all().size() < 3; ++k) three.add(few.all()[k]);
  return {three.all()[0], three.all()[1], three.all()[2]};
}

}  // namespace

void findEnclosingCircle(const DiagramCore& diagram, Site& circle, std::vector<SiteId>& touching) {
  std::vector<SiteId> hull;
  listHull(diagram, hull);
  keepFirstOccurrences(hull);
  touching.clear();
  if (hull.empty()) return;
  FlatArray<Site> sites;
  for (const SiteId id : hull) sites.push_back(diagram.site(diagram.ids().slotOf(id)));
  if (hull.size() == 1) {
    circle = sites[0];
    touching = hull;
    return;
  }

  // From a circle around some sites to the smallest one around these and one that goes beyond: each
  // is larger than the one before, so it ends.
  Enclosure found(sites[0], sites[1]);
  for (;;) {
    const Site* beyond = nullptr;
    double most = 0;
    for (const Site& site : sites) {
      const double excess = found.excess(site);
      if ((beyond == nullptr || excess > most) && found.holds(site) == Sign::kNegative) {
        beyond = &site;
        most = excess;
      }
    }
    if (beyond == nullptr) break;
    Few few(*beyond);
    few.add(found);
    found = around(few.all());
  }

  FlatArray<Site> ends;
  FlatArray<Keyed> ids;
  for (std::size_t k = 0; k < sites.size(); ++k) {
    if (found.holds(sites[k]) != Sign::kZero) continue;
    ends.push_back(sites[k]);
    ids.push_back({hull[k], 0});
  }
  sortByKey(ids);
  for (const Keyed& entry : ids) touching.push_back(entry.key);
  circle = canonical(found, {ends.data(), ends.size()}).rounded();
}

}  // namespace apollonius::internal
