// Is a disc within another?
#pragma once

#include "number/approx.h"
#include "number/sign.h"
#include "predicate/site.h"

namespace apollonius::internal {

/// Does a cover b, that is, is disc b within disc a (touching from within included)?
/// Laws: reflexive, transitive; both ways only for identical sites. Degree 2.
[[nodiscard]] bool covers(const Site& a, const Site& b);

/// Does q cover the corner? Infinity is covered by none.
inline bool coversCorner(const Site& q, Corner c) { return c != nullptr && covers(q, *c); }

namespace stages {

/// The sign of p, the squared length of the outer tangent: (xa-xb)² + (ya-yb)² - (ra-rb)². In
/// doubles with an error bound; in doubles that are exact; exactly.
[[nodiscard]] MaybeSign lorentzFilter(const Site& a, const Site& b);
[[nodiscard]] MaybeSign lorentzMiddle(const Site& a, const Site& b);
[[nodiscard]] Sign lorentzExact(const Site& a, const Site& b);

}  // namespace stages

}  // namespace apollonius::internal
