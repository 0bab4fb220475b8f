// The smallest circle around two or three circles, and which further circles are within it.
//
// A circle of centre p and radius R that a site touches from inside has |p - c| + r = R: it is the
// circle of clearance R that the site with the opposite weight touches from outside. So questions
// about three sites are questions about a Voronoi vertex of opposite sites.
#pragma once

#include <array>
#include <cstddef>

#include "number/sign.h"
#include "predicate/site.h"
#include "predicate/voronoi_circle.h"

namespace apollonius::internal {

/// The smallest circle around its sites, all of which touch it from inside.
class Enclosure {
 public:
  /// REQUIRES: neither covers the other.
  Enclosure(const Site& a, const Site& b);
  /// REQUIRES: no circle around two of them has the third one in it without touching it, and none
  /// covers another.
  Enclosure(const Site& a, const Site& b, const Site& c);

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] const Site& site(std::size_t k) const { return sites_[k]; }

  /// Is a site within the circle? Positive: yes, without touching it; zero: it touches from inside;
  /// negative: it goes beyond. Exact: of degree 4 for two sites, 8 for three. REQUIRES: the site
  /// covers none of these.
  [[nodiscard]] Sign holds(const Site& q) const;
  /// How far a site goes beyond the circle, about.
  [[nodiscard]] double excess(const Site& q) const;

  /// Centre and radius: rounded once from twice the digits for two sites; for three the centre is
  /// rounded correctly (commonVoronoiCircle). The same bits for any three that touch one circle if
  /// the lightest is among them.
  [[nodiscard]] Site rounded() const;

 private:
  [[nodiscard]] Sign holdsBeside(const Site& q) const;

  std::array<Site, 3> sites_;     // three of them counter-clockwise
  std::array<Site, 3> opposite_;  // sites_ with opposite weights
  std::size_t size_;
  VoronoiCircle circle_;  // its clearance is R
};

}  // namespace apollonius::internal
