// The span of the directions of an unbounded edge: the turn from one end to the other.
#pragma once

#include "number/root_sign.h"
#include "number/sign.h"
#include "predicate/formulas.h"

namespace apollonius::internal::stages {

/// The sign of d_l × d_k, the outer normals of the half-planes (l, i) and (i, k) that touch the
/// reference site i. Up to a positive factor it is cross · P + dot · Q with
///     P = r_l r_k - √(p_l p_k),     Q = r_l √p_k + r_k √p_l,
/// and the squares of the two terms differ by a positive multiple of P² - dot² (docs/PREDICATES.md,
/// "Edge conflict"). Degree 4.
template <class Kernel, class T>
Sign spanSign(Kernel& kernel, const Row<T>& l, const Row<T>& k) {
  using roundings::kRow;
  using roundings::kSpan;
  const SpanForm<T> form(l, k);
  // Equal weights: Q is zero and P negative.
  if (kernel.hasEqualWeights()) return -kernel.sign(form.cross, kSpan.cross);
  // The sign of x - √(p_l p_k).
  const auto signLessRoot = [&](const T& x, Roundings count) {
    return signOfSum(kernel.sign(x, count), Sign::kNegative, [&] {
      return kernel.sign(x * x - form.tangents, count * count - kSpan.tangents);
    });
  };
  const Sign p = signLessRoot(form.weights, kSpan.weights);
  const Sign q = signOfSum(kernel.sign(l.r, kRow.r), kernel.sign(k.r, kRow.r), [&] {
    return kernel.sign(SpanForm<T>::squares(l, k), SpanForm<Roundings>::squares(kRow, kRow));
  });
  return signOfSum(kernel.sign(form.cross, kSpan.cross) * p, kernel.sign(form.dot, kSpan.dot) * q,
                   [&] {
                     // P² - dot² = (P - dot) (P + dot)
                     constexpr Roundings kCount = kSpan.weights - kSpan.dot;
                     return signLessRoot(form.weights - form.dot, kCount) *
                            signLessRoot(form.weights + form.dot, kCount);
                   });
}

}  // namespace apollonius::internal::stages
