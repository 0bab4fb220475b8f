#include "number/twofold.h"

#include <cmath>

namespace apollonius::internal {

namespace {

/// Rounding error of `product`, which is x y rounded: computed from the two halves of each factor.
double lostOfProduct(double x, double y, double product) {
  const auto upper = [](double v) {
    const double shifted = v * (powerOfTwo(27) + 1);
    return shifted - (shifted - v);
  };
  const double x1 = upper(x), y1 = upper(y), x2 = x - x1, y2 = y - y1;
  return x2 * y2 - (((product - x1 * y1) - x2 * y1) - x1 * y2);
}

/// Rounding error of `sum`, which is x + y rounded.
double lostOfSum(double x, double y, double sum) {
  const double added = sum - x;
  return (x - (sum - added)) + (y - added);
}

/// x + y, where x is the larger.
Twofold normalized(double x, double y) {
  const double sum = x + y;
  return {sum, y - (sum - x)};
}

}  // namespace

Twofold productOf(double x, double y) {
  const double product = x * y;
  return {product, lostOfProduct(x, y, product)};
}

Twofold operator+(const Twofold& a, const Twofold& b) {
  const double sum = a.value + b.value, rests = a.rest + b.rest;
  const Twofold upper = normalized(sum, lostOfSum(a.value, b.value, sum) + rests);
  return normalized(upper.value, lostOfSum(a.rest, b.rest, rests) + upper.rest);
}

Twofold operator*(const Twofold& a, const Twofold& b) {
  const Twofold product = productOf(a.value, b.value);
  return normalized(product.value, product.rest + (a.value * b.rest + a.rest * b.value));
}

/// Adds to the quotient in doubles the remainder, divided.
Twofold operator/(const Twofold& a, const Twofold& b) {
  const double quotient = a.value / b.value;
  const Twofold left = a - b * quotient;
  return normalized(quotient, left.value / b.value);
}

/// Adds to the root in doubles the remainder, divided by twice the root.
Twofold root(const Twofold& a) {
  const double rooted = std::sqrt(a.value);
  const Twofold left = a - productOf(rooted, rooted);
  return normalized(rooted, left.value / (2 * rooted));
}

}  // namespace apollonius::internal
