#include "predicate/face_pair.h"

#include "predicate/circle_pair.h"

namespace apollonius {

namespace {

PairSite bothOf(Corner a, Corner b) { return {Pair{a->x, b->x}, Pair{a->y, b->y}, Pair{a->r, b->r}}; }

PairSite difference(const PairSite& a, const PairSite& b) { return {a.x - b.x, a.y - b.y, a.r - b.r}; }

Pair larger(Pair a, Pair b) { return a > b ? a : b; }

PairRow rowOf(const PairSite& d) {
  const Pair xy = d.x * d.x + d.y * d.y, rr = d.r * d.r;
  return {d.x, d.y, d.r, xy - rr, xy + rr, larger(larger(absolute(d.x), absolute(d.y)), absolute(d.r))};
}

}  // namespace

bool areCertainFaces(const std::array<FaceWithSurroundings, 2>& faces, std::array<VoronoiCircle, 2>& circles) noexcept {
  const auto corner = [&](unsigned c) { return bothOf(faces[0].corners[c], faces[1].corners[c]); };
  const PairSite q = corner(0), sj = corner(1), sk = corner(2);
  const PairRow j = rowOf(difference(sj, q)), k = rowOf(difference(sk, q));
  const PairCircle circle = circlePair(q, j, k, difference(sk, sj));
  const Pair most = pairOf(kLargestDifference);
  PairMask isGood = (j.l < most) & (k.l < most) & (circle.error < pairOf(std::numeric_limits<double>::infinity()));
  for (unsigned c = 0; c < 3; ++c) {  // circleFilter's "no"
    const PairSite beyond = bothOf(faces[0].beyond[c], faces[1].beyond[c]);
    const Pair dx = circle.x - beyond.x, dy = circle.y - beyond.y;
    const Pair h = circle.s + beyond.r;
    const Pair high = h + (circle.error + 2 * kUnitRoundoff * absolute(h));
    isGood &= (high < pairOf(0)) | (high * high * (1 + 8 * kUnitRoundoff) < dx * dx + dy * dy);
  }
  for (unsigned f = 0; f < 2; ++f) circles[f] = {circle.x[f], circle.y[f], circle.s[f], roundedUp(circle.error[f]), -1};
  return (isGood[0] & isGood[1]) != 0;
}

}  // namespace apollonius
