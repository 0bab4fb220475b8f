#include "predicate/predicates.h"

#include <utility>

#include "predicate/direction.h"
#include "predicate/reference_site.h"
#include "predicate/shadow_check.h"
#include "predicate/stages.h"

namespace apollonius {

using stages::counts;

namespace {

using Count = unsigned long long;

/// The answer of the exact stage, computed at most once, and the shadow check of the stages before.
/// `Meaning` maps signs that mean the same to one.
template <class Exact, class Meaning = AsItIs>
class Question {
 public:
  Question(Exact exact, Count& count, Meaning meaning = {})
      : exact_(exact), count_(count), meaning_(meaning) {}

  /// Has the stage an answer? Counts it.
  bool isSettledBy(MaybeSign answer, Count& count) {
    shadowCheck(answer, exact_, meaning_);
    count += answer.known;
    sign_ = answer.sign;
    return answer.known;
  }
  /// The answer: of the stage that settled the question, or the exact one.
  [[nodiscard]] Sign settled() const { return sign_; }
  [[nodiscard]] Sign exact() {
    ++count_;
    return exact_();
  }

 private:
  Exact exact_;
  Count& count_;
  Meaning meaning_;
  Sign sign_ = Sign::kZero;
};

/// Where a positive sign means yes and anything else no.
struct PositiveOrNot {
  Sign operator()(Sign s) const { return s == Sign::kPositive ? Sign::kPositive : Sign::kNegative; }
};

/// Vertex conflict before the degenerate rule, for any face and any one infinite site of the four.
Sign vertexSign(const Site& i, Corner j, Corner k, Corner q) {
  Question question([&] { return stages::vertexExact(i, j, k, q); }, counts().vertexExact);
  if (question.isSettledBy(stages::vertexOfPoints(i, j, k, q), counts().vertexOfPoints))
    return question.settled();
  if (question.isSettledBy(stages::vertexFilter(i, j, k, q), counts().vertexFilter))
    return question.settled();
  if (question.isSettledBy(stages::vertexMiddle(i, j, k, q), counts().vertexMiddle))
    return question.settled();
  if (question.isSettledBy(stages::vertexFixed(i, j, k, q), counts().vertexFixed))
    return question.settled();
  return question.exact();
}

/// Is the vertex of the face nearer to q than to the face's sites? q is infinite to ask whether the
/// face has no circle.
bool circleIsBeaten(Corner i, Corner j, Corner k, Corner q) {
  rotateToReference(i, j, k);
  const Sign sign = vertexSign(*i, j, k, q);
  if (sign != Sign::kZero) return sign == Sign::kPositive;
  ++counts().vertexDegenerate;
  return stages::vertexDegenerate(*i, j, k, q);
}

/// A coordinate of a ray in the frame of a face's direction.
Sign raySign(double x, double y, const VoronoiCircle& circle, const Site& i, Corner j, Corner k,
             stages::RayPart part) {
  const auto byCircle = [&]() -> MaybeSign {
    Arrow d = directionOf(circle, i);
    if (part == stages::RayPart::kAlong) d = {d.y, -d.x, d.error};  // turned by a quarter
    return turn(d, directionOf(x, y, i));
  };
  Question question([&] { return stages::rayExact(x, y, i, j, k, part); }, counts().rayExact);
  if (question.isSettledBy(byCircle(), counts().rayCached)) return question.settled();
  if (question.isSettledBy(stages::rayFilter(x, y, i, j, k, part), counts().rayFilter))
    return question.settled();
  if (question.isSettledBy(stages::rayMiddle(x, y, i, j, k, part), counts().rayMiddle))
    return question.settled();
  if (question.isSettledBy(stages::rayFixed(x, y, i, j, k, part), counts().rayFixed))
    return question.settled();
  return question.exact();
}

bool coversCorner(const Site& q, Corner c) { return c != nullptr && covers(q, *c); }

/// `atK`, `atL`: cached circles of the edge's faces, or nullptr.
bool probeIsInRange(EdgeCorners e, const VoronoiCircle* atK, const VoronoiCircle* atL,
                    const Site& q, stages::Probe probe) {
  if (isBetterReference(e.j, e.i)) {  // the same edge seen from its other side
    e = {e.j, e.i, e.l, e.k};
    std::swap(atK, atL);
  }
  Question question([&] { return stages::edgeExact(*e.i, e.j, e.k, e.l, q, probe); },
                    counts().edgeExact, PositiveOrNot{});
  const auto answer = [&] {
    if (atK != nullptr &&
        question.isSettledBy(stages::edgeCircleFilter(*e.i, e.j, *atK, *atL, q, probe),
                             counts().edgeCached)) {
      return question.settled();
    }
    if (question.isSettledBy(stages::edgeFilter(*e.i, e.j, e.k, e.l, q, probe),
                             counts().edgeFilter))
      return question.settled();
    if (question.isSettledBy(stages::edgeMiddle(*e.i, e.j, e.k, e.l, q, probe),
                             counts().edgeMiddle))
      return question.settled();
    if (question.isSettledBy(stages::edgeFixed(*e.i, e.j, e.k, e.l, q, probe), counts().edgeFixed))
      return question.settled();
    return question.exact();
  };
  return answer() == Sign::kPositive;
}

}  // namespace

bool covers(const Site& a, const Site& b) {
  if (a.r <= b.r) return a.r == b.r && a.x == b.x && a.y == b.y;
  Question question([&] { return stages::lorentzExact(a, b); }, counts().lorentzExact);
  if (question.isSettledBy(stages::lorentzFilter(a, b), counts().lorentzFilter))
    return question.settled() != Sign::kPositive;
  if (question.isSettledBy(stages::lorentzMiddle(a, b), counts().lorentzMiddle))
    return question.settled() != Sign::kPositive;
  return question.exact() != Sign::kPositive;
}

Sign compareDistance(double x, double y, const Site& a, const Site& b) {
  Question question([&] { return stages::distanceExact(x, y, a, b); }, counts().distanceExact);
  if (question.isSettledBy(stages::distanceFilter(x, y, a, b), counts().distanceFilter))
    return question.settled();
  if (question.isSettledBy(stages::distanceMiddle(x, y, a, b), counts().distanceMiddle))
    return question.settled();
  if (question.isSettledBy(stages::distanceFixed(x, y, a, b), counts().distanceFixed))
    return question.settled();
  return question.exact();
}

bool isNearer(double x, double y, const Site& a, const Site& b) {
  const Sign sign = compareDistance(x, y, a, b);
  return sign == Sign::kPositive || (sign == Sign::kZero && precedes(a, b));
}

bool isVertexInConflict(Corner i, Corner j, Corner k, const Site& q) {
  if (coversCorner(q, i) || coversCorner(q, j) || coversCorner(q, k)) return true;
  return circleIsBeaten(i, j, k, &q);
}

bool isVertexInConflict(const VoronoiCircle& circle, Corner i, Corner j, Corner k, const Site& q) {
  const MaybeSign filtered = circleFilter(circle, q);
  shadowCheck(filtered,
              [&] { return isVertexInConflict(i, j, k, q) ? Sign::kPositive : Sign::kNegative; });
  if (filtered.known) return filtered.sign == Sign::kPositive;
  return isVertexInConflict(i, j, k, q);
}

bool hasVoronoiCircle(const Site& i, const Site& j, const Site& k) {
  return !circleIsBeaten(&i, &j, &k, nullptr);
}

Bearing bearingOf(double x, double y, const VoronoiCircle& circle, const Site& i, Corner j,
                  Corner k) {
  const Sign left = raySign(x, y, circle, i, j, k, stages::RayPart::kLeftwards);
  if (left != Sign::kZero) return left == Sign::kPositive ? Bearing::kLeft : Bearing::kRight;
  const Sign along = raySign(x, y, circle, i, j, k, stages::RayPart::kAlong);
  return along == Sign::kPositive ? Bearing::kAlong : Bearing::kOpposite;
}

bool touchesCircle(const Site& i, const Site& j, const Site& k, const Site& q) {
  Corner a = &i, b = &j, c = &k;
  rotateToReference(a, b, c);
  return vertexSign(*a, b, c, &q) == Sign::kZero;
}

bool isInteriorInConflict(const EdgeCorners& edge, const Site& q) {
  return probeIsInRange(edge, nullptr, nullptr, q, stages::Probe::kMiddle);
}

bool isInteriorInConflict(const EdgeCorners& edge, const VoronoiCircle& atK,
                          const VoronoiCircle& atL, const Site& q) {
  return probeIsInRange(edge, &atK, &atL, q, stages::Probe::kMiddle);
}

bool isEntireEdgeInConflict(const EdgeCorners& edge, const Site& q) {
  if (coversCorner(q, edge.i) || coversCorner(q, edge.j)) return true;
  return !probeIsInRange(edge, nullptr, nullptr, q, stages::Probe::kOpposite);
}

bool isEntireEdgeInConflict(const EdgeCorners& edge, const VoronoiCircle& atK,
                            const VoronoiCircle& atL, const Site& q) {
  if (coversCorner(q, edge.i) || coversCorner(q, edge.j)) return true;
  return !probeIsInRange(edge, &atK, &atL, q, stages::Probe::kOpposite);
}

}  // namespace apollonius
