#include "support/stage_checks.h"

#include <algorithm>
#include <cstdio>
#include <limits>
#include <utility>

#include "predicate/compute_circle.h"
#include "predicate/direction.h"
#include "predicate/predicates.h"
#include "predicate/reference_site.h"

namespace apollonius::test {

using namespace internal;

namespace {

constexpr Sign yesOrNo(bool yes) { return yes ? Sign::kPositive : Sign::kNegative; }

/// An edge's answer is "positive" or "not positive".
MaybeSign positiveOrNot(MaybeSign sign) {
  return {yesOrNo(sign.sign == Sign::kPositive), sign.known};
}

}  // namespace

StageChecks::StageChecks() {
  tallies_.resize(kCount);
  tallies_[kCovers] = {"covers", {{"filter"}, {"middle"}}};
  tallies_[kDistance] = {"distance", {{"filter"}, {"middle"}, {"fixed"}}};
  tallies_[kCircle] = {
      "circle exists",
      {{"doubles"}, {"fan"}, {"points"}, {"twofold"}, {"filter"}, {"middle"}, {"fixed"}}};
  tallies_[kVertex] = {"vertex", {{"circle"}, {"fan circle"}, {"filter"}, {"middle"}, {"fixed"}}};
  tallies_[kPoints] = {
      "vertex, one weight",
      {{"circle"}, {"fan circle"}, {"points"}, {"twofold"}, {"filter"}, {"middle"}, {"fixed"}}};
  tallies_[kRule] = {"degenerate rule", {{"doubles"}}};
  tallies_[kEdge] = {"edge", {{"shortcut"}, {"circles"}, {"filter"}, {"middle"}, {"fixed"}}};
  tallies_[kRay] = {"ray", {{"circle"}, {"filter"}, {"middle"}, {"fixed"}}};
  tallies_[kOrder] = {"order along an edge", {{"circles"}}};
  tallies_[kHull] = {"turn of the hull", {{"circles"}}};
  tallies_[kShadow] = {"turn between shadows", {{"filter"}}};
  tallies_[kUp] = {"normal points up", {{"circle"}}};
}

void StageChecks::disagree(const char* question, const char* stage) {
  if (++disagreements_ > 10) return;
  report_ +=
      std::string(question) + ": " + stage + " contradicts the exact stage\n" + toText(*call_);
}

void StageChecks::compare(Question question, Sign exact, std::initializer_list<MaybeSign> stages) {
  Tally& tally = tallies_[question];
  ++tally.asked;
  tally.zeros += exact == Sign::kZero;
  bool isSettled = false;
  auto stage = tally.stages.begin();
  for (const MaybeSign& answer : stages) {
    if (answer.known) {
      ++stage->knows;
      stage->settles += !isSettled;
      isSettled = true;
      if (answer.sign != exact) disagree(tally.name, stage->name);
    }
    ++stage;
  }
  tally.left += !isSettled;
}

void StageChecks::expect(bool holds, const char* what) {
  if (!holds) disagree(what, "the predicate");
}

bool StageChecks::covers(const Site& a, const Site& b) {
  bool exact = a.r == b.r && a.x == b.x && a.y == b.y;
  if (a.r > b.r) {
    const Sign p = stages::lorentzExact(a, b);
    compare(kCovers, p, {stages::lorentzFilter(a, b), stages::lorentzMiddle(a, b)});
    exact = p != Sign::kPositive;
  }
  expect(apollonius::internal::covers(a, b) == exact, "covers");
  return exact;
}

void StageChecks::askDistances() {
  const double x = call_->x, y = call_->y;
  for (std::size_t k = 0; k < call_->sites.size(); ++k) {
    const Site &a = call_->sites[k], &b = call_->sites[(k + 1) % call_->sites.size()];
    const Sign exact = stages::distanceExact(x, y, a, b);
    compare(kDistance, exact,
            {stages::distanceFilter(x, y, a, b), stages::distanceMiddle(x, y, a, b),
             stages::distanceFixed(x, y, a, b)});
    const bool isNearerExactly =
        exact == Sign::kPositive || (exact == Sign::kZero && precedes(a, b));
    expect(compareDistance(x, y, b, a) == -exact && isNearer(x, y, a, b) == isNearerExactly,
           "distance");
  }
}

bool StageChecks::exists(Corner i, Corner j, Corner k) {
  if (i == nullptr || j == nullptr || k == nullptr) return true;
  Corner a = i, b = j, c = k;
  rotateToReference(a, b, c);
  const Sign beaten = stages::vertexExact(*a, b, c, nullptr);
  VoronoiCircle circle, fromFan;
  const bool isCertain = findCertainVoronoiCircle(i, j, k, circle);
  const std::array<Corner, 3> face{i, j, k};
  CircleFan::computeFaces({&face, 1}, {&fromFan, 1});
  const bool isCertainOfFan = fromFan.error < std::numeric_limits<float>::infinity();
  compare(kCircle, beaten,
          {{Sign::kNegative, isCertain},
           {Sign::kNegative, isCertainOfFan},
           stages::vertexOfPoints(*a, b, c, nullptr),
           stages::vertexTwofold(*a, b, c, nullptr),
           stages::vertexFilter(*a, b, c, nullptr),
           stages::vertexMiddle(*a, b, c, nullptr),
           stages::vertexFixed(*a, b, c, nullptr)});
  const bool does = beaten == Sign::kNegative;
  expect(findVoronoiCircle(i, j, k, circle) == does && hasVoronoiCircle(*i, *j, *k) == does,
         "circle exists");
  return does;
}

/// REQUIRES: the face has a circle, none of its sites covers another or q.
bool StageChecks::isInConflict(const Face& face, const Site& q) {
  Corner i = face.corners[0], j = face.corners[1], k = face.corners[2];
  rotateToReference(i, j, k);
  const Sign exact = stages::vertexExact(*i, j, k, &q);
  bool yes = exact == Sign::kPositive;
  if (exact == Sign::kZero) {
    // As docs/PREDICATES.md has it, from the exact stage.
    using stages::FaceCorner;
    const FaceCorner z = j == nullptr   ? FaceCorner::kJ
                         : k == nullptr ? FaceCorner::kK
                                        : FaceCorner::kReference;
    yes = (z == FaceCorner::kReference && precedes(*i, q)) ||
          stages::isOppositeExact(*i, j, k, &q, z);
    compare(kRule, yesOrNo(yes), {{yesOrNo(stages::vertexDegenerate(*i, j, k, &q)), true}});
  }
  // Circles settle the question itself, so they may say nothing of zeros that the rule turns.
  const auto ofCircle = [&](const VoronoiCircle& circle) {
    const MaybeSign answer = circleFilter(circle, q);
    if (answer.known && answer.sign != yesOrNo(yes)) disagree("vertex", "a circle");
    return MaybeSign{exact, answer.known};
  };
  VoronoiCircle fromFan = kMissingCircle;
  if (k != nullptr && j != nullptr) {
    // Seen from another of its sites.
    const std::array<Corner, 3> turned{j, k, i};
    CircleFan::computeFaces({&turned, 1}, {&fromFan, 1});
  }
  const bool areEqual =
      (j == nullptr || j->r == i->r) && (k == nullptr || k->r == i->r) && q.r == i->r;
  const MaybeSign byCircle = ofCircle(face.circle), byFan = ofCircle(fromFan);
  const MaybeSign filter = stages::vertexFilter(*i, j, k, &q),
                  middle = stages::vertexMiddle(*i, j, k, &q);
  const MaybeSign fixed = stages::vertexFixed(*i, j, k, &q),
                  points = stages::vertexOfPoints(*i, j, k, &q),
                  twofold = stages::vertexTwofold(*i, j, k, &q);
  if (areEqual) {
    compare(kPoints, exact, {byCircle, byFan, points, twofold, filter, middle, fixed});
  } else {
    expect(!points.known && !twofold.known, "vertex of points");
    compare(kVertex, exact, {byCircle, byFan, filter, middle, fixed});
  }
  expect(
      isVertexInConflict(face.circle, face.corners[1], face.corners[2], face.corners[0], q) == yes,
      "vertex");
  if (j != nullptr && k != nullptr) {
    expect(touchesCircle(*face.corners[0], *face.corners[1], *face.corners[2], q) ==
               (exact == Sign::kZero),
           "touches");
  }
  return yes;
}

void StageChecks::askRays(const Face& face) {
  const double x = call_->x, y = call_->y;
  for (std::size_t c = 0; c < 3; ++c) {
    const Corner i = face.corners[c], j = face.corners[(c + 1) % 3], k = face.corners[(c + 2) % 3];
    if (i == nullptr || (x == i->x && y == i->y)) continue;
    Sign exact[2] = {};
    for (const stages::RayPart part : {stages::RayPart::kLeftwards, stages::RayPart::kAlong}) {
      Sign& sign = exact[static_cast<std::size_t>(part)];
      sign = stages::rayExact(x, y, *i, j, k, part);
      compare(kRay, sign,
              {stages::rayCircleFilter(x, y, face.circle, *i, part),
               stages::rayFilter(x, y, *i, j, k, part), stages::rayMiddle(x, y, *i, j, k, part),
               stages::rayFixed(x, y, *i, j, k, part)});
    }
    const Bearing bearing = exact[0] == Sign::kPositive   ? Bearing::kLeft
                            : exact[0] == Sign::kNegative ? Bearing::kRight
                            : exact[1] == Sign::kPositive ? Bearing::kAlong
                                                          : Bearing::kOpposite;
    expect(exact[0] != Sign::kZero || exact[1] != Sign::kZero, "ray without a place");
    expect(bearingOf(x, y, face.circle, *i, j, k) == bearing, "bearing");
  }
}

void StageChecks::askFace(Corner i, Corner j, Corner k) {
  if (!exists(i, j, k)) return;
  faces_.push_back({{i, j, k}, voronoiCircle(i, j, k)});
}

void StageChecks::askFaces() {
  faces_.clear();
  const auto& v = visible_;
  askFace(v[0], v[1], nullptr);
  askFace(v[1], v[0], nullptr);
  if (v.size() > 3) {
    askFace(v[0], v[2], nullptr);
    askFace(v[2], v[0], nullptr);
  }
  for (std::size_t k = 2; k < v.size() && k < 4; ++k) {
    askFace(v[0], v[1], v[k]);
    askFace(v[1], v[0], v[k]);
  }
  for (const Face& face : faces_) {
    for (const Site* q : v) {
      if (std::find(face.corners.begin(), face.corners.end(), q) == face.corners.end())
        (void)isInConflict(face, *q);
    }
    if (v.size() < 3 || face.corners[2] != nullptr) askRays(face);
  }
}

const StageChecks::Face* StageChecks::faceOf(Corner i, Corner j, Corner k) const {
  const auto found = std::find_if(faces_.begin(), faces_.end(), [&](const Face& f) {
    return f.corners == std::array{i, j, k} || f.corners == std::array{j, k, i} ||
           f.corners == std::array{k, i, j};
  });
  return found == faces_.end() ? nullptr : &*found;
}

void StageChecks::askEdge(const EdgeCorners& given, const Site& q) {
  EdgeCorners e = given;
  if (isBetterReference(e.j, e.i)) e = {e.j, e.i, e.l, e.k};
  const Face *atK = faceOf(e.i, e.j, e.k), *atL = faceOf(e.j, e.i, e.l);
  if (atK == nullptr || atL == nullptr) return;

  // Is it an edge? (Its order from cached circles against what takes none.)
  const bool isEdge = isDelaunayEdge(e, kMissingCircle, kMissingCircle);
  if (e.j != nullptr && e.k != nullptr && e.l != nullptr && e.k != e.l) {
    const MaybeSign order = turn(directionOf(atL->circle, *e.i), directionOf(atK->circle, *e.i));
    if (order.known && order.sign == Sign::kNegative) compare(kOrder, yesOrNo(isEdge), {order});
  }

  for (const auto probe : {stages::Probe::kMiddle, stages::Probe::kOpposite}) {
    // The ends decide which of the two is asked; stages that take no circles do not mind.
    bool isAsked = false;
    if (isEdge) {
      const bool kIs = isVertexInConflict(e.i, e.j, e.k, q),
                 lIs = isVertexInConflict(e.j, e.i, e.l, q);
      isAsked = kIs == lIs && kIs == (probe == stages::Probe::kOpposite);
    }
    const Sign exact = positiveOrNot({stages::edgeExact(*e.i, e.j, e.k, e.l, q, probe), true}).sign;
    MaybeSign shortcut{}, circles{};
    if (isAsked) {
      circles = stages::edgeCircleFilter(*e.i, e.j, atK->circle, atL->circle, q, probe);
      if (probe == stages::Probe::kOpposite && e.j != nullptr) {
        shortcut = {Sign::kNegative,
                    isSurelyInConflictBetweenEnds(*e.i, *e.j, atK->circle, atL->circle, q)};
      }
      if (probe == stages::Probe::kMiddle) {
        expect(isInteriorInConflict(e, atK->circle, atL->circle, q) == (exact == Sign::kPositive),
               "interior");
      } else {
        expect(isEntireEdgeInConflict(e, atK->circle, atL->circle, q) == (exact != Sign::kPositive),
               "entire edge");
      }
    }
    compare(kEdge, exact,
            {shortcut, positiveOrNot(circles),
             positiveOrNot(stages::edgeFilter(*e.i, e.j, e.k, e.l, q, probe)),
             positiveOrNot(stages::edgeMiddle(*e.i, e.j, e.k, e.l, q, probe)),
             positiveOrNot(stages::edgeFixed(*e.i, e.j, e.k, e.l, q, probe))});
  }
}

void StageChecks::askEdges() {
  const auto& v = visible_;
  const Site& q = *v.back();
  if (v.size() >= 3) {
    askEdge({v[0], v[1], nullptr, nullptr}, q);
    // With infinity for a site, around v[0] and around v[1].
    askEdge({v[0], nullptr, v[1], v[1]}, q);
  }
  if (v.size() >= 4) {
    askEdge({v[0], nullptr, v[1], v[2]}, q);
    askEdge({v[0], nullptr, v[2], v[1]}, q);
    askEdge({v[0], v[1], v[2], v[2]}, q);
    askEdge({v[0], v[1], v[2], nullptr}, q);
    askEdge({v[0], v[1], nullptr, v[2]}, q);
  }
  if (v.size() >= 5) {
    askEdge({v[0], v[1], v[2], v[3]}, q);
    askEdge({v[0], v[1], v[3], v[2]}, q);
  }
}

void StageChecks::askHull() {
  const auto& v = visible_;
  const Site &i = *v[0], &j = *v[1];
  const VoronoiCircle plane = voronoiCircle(&i, &j, nullptr);
  const MaybeSign up{plane.y > 0 ? Sign::kPositive : Sign::kNegative,
                     plane.y > plane.slope || plane.y < -plane.slope};
  compare(kUp, yesOrNo(stages::normalIsUpExact(i, j)), {up});
  const Site& k = *v[v.size() > 2 ? 2 : 1];
  // From the normal of (i, j, infinity) to that of (k, i, infinity).
  const VoronoiCircle last = voronoiCircle(&k, &i, nullptr);
  compare(kHull, stages::spanExact(i, j, k), {turn(directionOf(plane, i), directionOf(last, i))});
  if (v.size() < 4) return;
  const bool isLarger = precedes(j, i);
  const Site &a = isLarger ? i : j, &b = isLarger ? j : i;
  compare(kShadow, stages::shadowTurnExact(a, b, *v[2], *v[3]),
          {stages::shadowTurnFilter(a, b, *v[2], *v[3])});
}

void StageChecks::ask(const CloseCall& call) {
  call_ = &call;
  askDistances();
  // Each next one that neither covers nor is covered by one before.
  visible_.clear();
  for (const Site& s : call.sites) {
    const bool isApart = std::none_of(visible_.begin(), visible_.end(), [&](const Site* t) {
      const bool isCovered = covers(*t, s);
      return covers(s, *t) || isCovered;
    });
    if (isApart) visible_.push_back(&s);
  }
  if (visible_.size() < 2) return;
  askFaces();
  askEdges();
  askHull();
}

std::uint64_t StageChecks::sum(std::uint64_t Tally::* count) const {
  std::uint64_t sum = 0;
  for (const Tally& tally : tallies_) sum += tally.*count;
  return sum;
}

void StageChecks::add(const StageChecks& other) {
  for (std::size_t k = 0; k < kCount; ++k) {
    tallies_[k].asked += other.tallies_[k].asked;
    tallies_[k].zeros += other.tallies_[k].zeros;
    tallies_[k].left += other.tallies_[k].left;
    for (std::size_t n = 0; n < tallies_[k].stages.size(); ++n) {
      tallies_[k].stages[n].settles += other.tallies_[k].stages[n].settles;
      tallies_[k].stages[n].knows += other.tallies_[k].stages[n].knows;
    }
  }
  disagreements_ += other.disagreements_;
}

std::string StageChecks::table() const {
  std::string text;
  char line[200];
  const auto share = [](std::uint64_t part, std::uint64_t all) {
    return all == 0 ? 0 : 100.0 * static_cast<double>(part) / static_cast<double>(all);
  };
  for (const Tally& tally : tallies_) {
    std::snprintf(line, sizeof line, "%-21s %12llu calls, %.2f %% zeros\n", tally.name,
                  static_cast<unsigned long long>(tally.asked), share(tally.zeros, tally.asked));
    text += line;
    for (const Stage& stage : tally.stages) {
      std::snprintf(line, sizeof line, "    %-12s settles %6.2f %%, knows %6.2f %%\n", stage.name,
                    share(stage.settles, tally.asked), share(stage.knows, tally.asked));
      text += line;
    }
    std::snprintf(line, sizeof line, "    %-12s settles %6.2f %%\n", "exact",
                  share(tally.left, tally.asked));
    text += line;
  }
  return text;
}

}  // namespace apollonius::test
