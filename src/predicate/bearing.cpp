#include "predicate/bearing.h"

#include "number/root_sign.h"
#include "predicate/direction.h"
#include "predicate/kernels.h"
#include "predicate/long_kernels.h"
#include "predicate/question.h"

namespace apollonius::internal {

namespace stages {

namespace {

/// Rows 0, 1 are j, k of a face of the reference site's, row 2 a point. Up to a positive factor,
/// the direction d of the face's vertex is (√D v - w u, -√D u - w v) for the chord (u, v, w) from j
/// to k. So with turn = u y - v x and along = u x + v y of the point (x, y):
///     cross(d, point) = √D along - w turn,     dot(d, point) = -√D turn - w along,
/// and, as D = u² + v² - w², the squares of the two terms differ by (along² - w² (x² + y²)) (u² +
/// v²), or the same with turn².
template <class Kernel>
Sign raySign(Kernel& kernel, RayPart part) {
  using T = typename Kernel::Number;
  using roundings::kChord;
  using roundings::kRay;
  using roundings::kRayForm;
  const Row<T> point = kernel.row(2);
  const Chord<T> end = chordOf(kernel.row(0), kernel.row(1));
  const Chord<T> ray{point.x, point.y, T(0)};
  const EdgeForm<T> form(end, ray);
  const bool isLeftwards = part == RayPart::kLeftwards;
  const T& rooted = isLeftwards ? form.along : form.turn;  // the factor of √D
  const T& other = isLeftwards ? form.turn : form.along;
  const Sign first =
      isLeftwards ? kernel.sign(rooted, kRayForm.along) : -kernel.sign(rooted, kRayForm.turn);
  if (kernel.hasEqualWeights()) return first;
  const Sign second = -(kernel.sign(end.w, kChord.w) * kernel.sign(other, kRayForm.turn));
  return signOfSum(first, second, [&] {
    return -kernel.sign(EdgeForm<T>::squares(end, ray, rooted),
                        EdgeForm<Roundings>::squares(kChord, kRay, kRayForm.along));
  });
}

/// The point is a row like those of sites, as if it had the weight of i.
template <class Kernel>
MaybeSign raySign(double x, double y, const Site& i, Corner j, Corner k, RayPart part) {
  const Site point{x, y, i.r};
  return decide<Kernel>(i, {j, k, &point}, [part](auto& kernel) { return raySign(kernel, part); });
}

}  // namespace

MaybeSign rayCircleFilter(double x, double y, const VoronoiCircle& circle, const Site& i,
                          RayPart part) {
  Arrow d = directionOf(circle, i);
  if (part == RayPart::kAlong) d = {d.y, -d.x, d.error};  // turned by a quarter
  return turn(d, directionOf(x, y, i));
}

MaybeSign rayFilter(double x, double y, const Site& i, Corner j, Corner k, RayPart part) {
  return raySign<FilterKernel>(x, y, i, j, k, part);
}

MaybeSign rayMiddle(double x, double y, const Site& i, Corner j, Corner k, RayPart part) {
  return raySign<UnitKernel>(x, y, i, j, k, part);
}

MaybeSign rayFixed(double x, double y, const Site& i, Corner j, Corner k, RayPart part) {
  return raySign<FixedKernel>(x, y, i, j, k, part);
}

Sign rayExact(double x, double y, const Site& i, Corner j, Corner k, RayPart part) {
  return raySign<ExactKernel>(x, y, i, j, k, part).sign;
}

}  // namespace stages

namespace {

/// A coordinate of a ray in the frame of a face's direction.
Sign raySign(double x, double y, const VoronoiCircle& circle, const Site& i, Corner j, Corner k,
             stages::RayPart part) {
  using stages::counts;
  Question question([&] { return stages::rayExact(x, y, i, j, k, part); }, counts().rayExact);
  if (question.isSettledBy(stages::rayCircleFilter(x, y, circle, i, part), counts().rayCached) ||
      question.isSettledBy(stages::rayFilter(x, y, i, j, k, part), counts().rayFilter) ||
      question.isSettledBy(stages::rayMiddle(x, y, i, j, k, part), counts().rayMiddle) ||
      question.isSettledBy(stages::rayFixed(x, y, i, j, k, part), counts().rayFixed))
    return question.settled();
  return question.exact();
}

}  // namespace

Bearing bearingOf(double x, double y, const VoronoiCircle& circle, const Site& i, Corner j,
                  Corner k) {
  const Sign left = raySign(x, y, circle, i, j, k, stages::RayPart::kLeftwards);
  if (left != Sign::kZero) return left == Sign::kPositive ? Bearing::kLeft : Bearing::kRight;
  const Sign along = raySign(x, y, circle, i, j, k, stages::RayPart::kAlong);
  return along == Sign::kPositive ? Bearing::kAlong : Bearing::kOpposite;
}

}  // namespace apollonius::internal
