#include "predicate/squared_tangent.h"

#include "number/dyadic.h"
#include "number/fp.h"

namespace apollonius::internal {

/// In doubles the error is at most 5u (x² + y² + r²) (number/approx.h); where that is more than a
/// 2^-40th of p, as when one circle nearly covers the other, p is computed exactly and rounded
/// once.
double squaredTangent(const Site& a, const Site& b) {
  const double x = b.x - a.x, y = b.y - a.y, r = b.r - a.r;
  const double squares = x * x + y * y, p = squares - r * r;
  if (p > powerOfTwo(-10) * (squares + r * r)) return p;
  const Dyadic dx = Dyadic(b.x) - Dyadic(a.x), dy = Dyadic(b.y) - Dyadic(a.y),
               dr = Dyadic(b.r) - Dyadic(a.r);
  return (dx * dx + dy * dy - dr * dr).rounded().value();
}

}  // namespace apollonius::internal
