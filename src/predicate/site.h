// A site, and the total order of sites that settles every tie.
#pragma once

namespace apollonius::internal {

/// A weighted point: centre (x, y) and weight r, in the user's unit. Finite, within the documented
/// range.
struct Site {
  double x = 0;
  double y = 0;
  double r = 0;
};

constexpr bool areIdentical(const Site& a, const Site& b) {
  return a.x == b.x && a.y == b.y && a.r == b.r;
}

/// The site without -0: -0 + 0 is 0, so that each number has one pattern of bits.
constexpr Site normalized(const Site& site) { return {site.x + 0.0, site.y + 0.0, site.r + 0.0}; }

/// The site with the same centre and the opposite weight. The distance to it is |p - c| + r, the
/// distance to the far side of the given one.
constexpr Site opposite(const Site& site) { return {site.x, site.y, -site.r}; }

/// A corner of a face, or an end of an edge: a site, or nullptr for the site at infinity.
using Corner = const Site*;

/// The order of docs/PREDICATES.md, "Degenerate position": by weight, then x, then y. The last of
/// several sites that tie wins. A strict weak order; only identical sites are equivalent.
constexpr bool precedes(const Site& a, const Site& b) {
  if (a.r != b.r) return a.r < b.r;
  if (a.x != b.x) return a.x < b.x;
  return a.y < b.y;
}

}  // namespace apollonius::internal
