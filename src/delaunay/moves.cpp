#include "delaunay/moves.h"

#include <algorithm>
#include <limits>

#include "delaunay/proof.h"
#include "predicate/circle_batch.h"
#include "predicate/compute_circle.h"
#include "predicate/covers.h"
#include "predicate/direction.h"
#include "predicate/edge_order.h"
#include "predicate/reference_site.h"

namespace apollonius::internal {

namespace {

/// Normal of a half-plane.
Arrow normalOf(const VoronoiCircle& circle) { return {circle.x, circle.y, circle.slope}; }

}  // namespace

std::span<const std::uint8_t> SiteMoves::apply(DelaunayGraph& delaunay, std::span<const Move> moves,
                                               Flips flips, std::size_t mostLeft) {
  delaunay_ = &delaunay;
  moves_ = moves;
  mostLeft_ = mostLeft;
  flips_.clear();
  constexpr std::size_t kFlipShare = 4, kFewFlips = 16;
  mostFlips_ =
      flips == Flips::kMaybe && delaunay.isProven() ? moves.size() / kFlipShare + kFewFlips : 0;
  reserveMoves(delaunay);
  isMade_.assign(moves.size(), 0);
  if (areHopeless()) return {isMade_.data(), moves.size()};
  reserveFaces(delaunay.graph());
  collectFaces();
  makeAll();
  // Computes the new circles, then checks. Where a face fails, an edge is flipped or a site goes
  // back, and the faces around are checked again. In the end all faces pass.
  computeCircles();
  if (mostFlips_ > 0) untangle();
  checkAll();
  bool holds = goesOn();
  if (holds) {
    swapCircles();
    holds = !asksHull_ || delaunay.beginProof().hullTurnsOnce();
    if (!holds) swapCircles();
  }
  const bool mayTryAgain =
      !holds && mostFlips_ > 0 && left_ <= mostLeft && flips_.size() <= mostLeft / 2;
  if (!holds) takeBackAll();
  for (const ChangedFace& changed : changed_) positionOf_[index(changed.face)] = kNoIndex;
  for (std::size_t k = 0; k < moves.size(); ++k) {
    isMade_[k] = isMoved_[index(moves[k].vertex)];
    isMoved_[index(moves[k].vertex)] = 0;
  }
  // A few flips have failed: tries again without flips, so that the sites there stay.
  if (mayTryAgain) return apply(delaunay, moves, Flips::kNone, mostLeft);
  return {isMade_.data(), moves.size()};
}

void SiteMoves::takeBack(DelaunayGraph& delaunay, std::span<const Move> moves) noexcept {
  for (const Move& move : moves) delaunay.setSite(move.vertex, move.to);
  const Graph& graph = delaunay.graph();
  for (const Move& move : moves) {
    for (const HalfedgeId h : graph.star(move.vertex)) delaunay.computeCircle(faceOf(h));
  }
}

void SiteMoves::reserveMoves(const DelaunayGraph& delaunay) {
  const std::size_t slots = delaunay.graph().vertexSlots();
  before_.resize(moves_.size());
  isMade_.reserve(moves_.size());
  if (isMoved_.size() < slots) {
    moveOf_.resize(slots);
    isMoved_.resize(slots, 0);
  }
}

/// Do the moves touch most faces? Then all faces are checked.
bool SiteMoves::areMost() const { return moves_.size() * 8 >= delaunay_->graph().faceCount(); }

void SiteMoves::reserveFaces(const Graph& graph) {
  if (positionOf_.size() < graph.faceSlots()) positionOf_.resize(graph.faceSlots(), kNoIndex);
  std::size_t faces = mostFlips_;  // each takes in one more face at most
  if (areMost()) {
    faces = graph.faceCount();
  } else {
    for (const Move& move : moves_) {
      for ([[maybe_unused]] const HalfedgeId h : graph.star(move.vertex)) ++faces;
    }
    faces = std::min(faces, graph.faceCount());
  }
  changed_.clear();
  changed_.reserve(faces);
  queue_.clear();
  queue_.reserve(faces);  // a face is in the queue once
  deferred_.clear();
  deferred_.reserve(faces);
  flips_.reserve(mostFlips_);
}

void SiteMoves::collectFaces() {
  const Graph& graph = delaunay_->graph();
  // Computes missing circles from the sites as they are now.
  if (areMost()) {
    delaunay_->computeMissingCircles();
    // Takes the faces in their order in memory.
    for (const FaceId f : graph.faces()) collect(f);
  } else {
    for (const Move& move : moves_) {
      for (const HalfedgeId h : graph.star(move.vertex)) {
        collect(faceOf(h));
        (void)delaunay_->circle(faceOf(h));
      }
    }
  }
  for (auto position = static_cast<std::uint32_t>(changed_.size()); position-- > 0;)
    queueAt(position);
}

/// Adds a face to changed_ if it is not there yet, as one that has no moved corner.
SiteMoves::ChangedFace& SiteMoves::collect(FaceId f) {
  std::uint32_t& position = positionOf_[index(f)];
  if (position == kNoIndex) {
    position = static_cast<std::uint32_t>(changed_.size());
    changed_.push_back({f, false, false, false, false, {}});
  }
  return changed_[position];
}

void SiteMoves::makeAll() {
  for (std::uint32_t k = 0; k < moves_.size(); ++k) {
    const VertexId v = moves_[k].vertex;
    before_[k] = delaunay_->site(v);
    delaunay_->setSite(v, moves_[k].to);
    moveOf_[index(v)] = k;
    isMoved_[index(v)] = 1;
  }
  left_ = 0;
  isStuck_ = asksHull_ = false;
}

/// Would too many sites have to stay, or too many edges have to be flipped? If nothing is flipped,
/// the share of sites that have to stay is about that of sites whose own faces contradict each
/// other after the moves. One such site in four means about one flip in twenty edges. Testing a
/// sample costs some percent of the whole.
bool SiteMoves::areHopeless() {
  constexpr std::size_t kShare = 16, kMost = 256, kFlippable = 4;
  const std::size_t sample = std::min(moves_.size() / kShare, kMost);
  if (moves_.size() <= mostLeft_ || sample < kShare) return false;
  delaunay_->computeMissingCircles();  // while the sites are where they were
  makeAll();
  std::size_t failing = 0;
  for (std::size_t k = 0; k < sample; ++k)
    failing += !keepsItsStar(moves_[k * moves_.size() / sample].vertex);
  takeBackAll();
  return mostFlips_ > 0 ? failing * kFlippable > sample
                        : failing * moves_.size() > mostLeft_ * sample;
}

/// Have all faces around v circles, and are their vertices in order along its edges?
bool SiteMoves::keepsItsStar(VertexId v) const {
  const Graph& graph = delaunay_->graph();
  const HalfedgeId begin = graph.outgoing(v);
  VoronoiCircle first, before, now;
  for (const HalfedgeId h : graph.star(v)) {
    const EdgeCorners e = delaunay_->edge(h);
    if (!findCertainVoronoiCircle(e.i, e.j, e.k, now)) return false;
    if (h == begin) {
      first = now;
    } else if (graph.target(h) != kInfinity && orderOfEnds(h, now, before) != Sign::kPositive) {
      return false;
    }
    before = now;
  }
  return graph.target(begin) == kInfinity || orderOfEnds(begin, first, before) == Sign::kPositive;
}

const Site& SiteMoves::siteBefore(VertexId v) const {
  return isMoved(v) ? before_[moveOf_[index(v)]] : delaunay_->site(v);
}

bool SiteMoves::hasMovedCorner(FaceId f) const {
  const Graph& graph = delaunay_->graph();
  return isMoved(graph.origin(halfedgeOf(f, 0))) || isMoved(graph.origin(halfedgeOf(f, 1))) ||
         isMoved(graph.origin(halfedgeOf(f, 2)));
}

/// Collects the faces that have moved corners.
void SiteMoves::computeCircles() {
  const Graph& graph = delaunay_->graph();
  CircleBatch batch([this](std::uint32_t position, const VoronoiCircle& circle) {
    changed_[position].circle = circle;
    if (!hasCircle(position)) computeCircle(position);
  });
  for (std::uint32_t position = 0; position < changed_.size(); ++position) {
    const HalfedgeId h = halfedgeOf(changed_[position].face, 0);
    const Corner i = delaunay_->corner(graph.origin(h)), j = delaunay_->corner(graph.target(h)),
                 k = delaunay_->corner(graph.apex(h));
    if (i == nullptr || j == nullptr || k == nullptr) {
      computeCircle(position);
    } else if (hasMovedCorner(changed_[position].face)) {
      changed_[position].isActive = true;
      batch.add(position, {i, j, k});
    }
  }
  batch.finish();
}

void SiteMoves::computeCircle(std::uint32_t position) {
  ChangedFace& changed = changed_[position];
  changed.isActive = changed.isFlipped || hasMovedCorner(changed.face);
  if (!changed.isActive) return;
  const EdgeCorners e = delaunay_->edge(halfedgeOf(changed.face, 0));
  if (!findCertainVoronoiCircle(e.i, e.j, e.k, changed.circle))
    changed.circle.error = std::numeric_limits<float>::infinity();
}

/// Checks the conditions for one face: its circle exists, its vertex comes in order along its
/// edges, and if it is at infinity, its normal has turned by less than a quarter, or the hull is
/// tested in the end. If an edge contradicts, it is flipped, else a site goes back, if it may now.
void SiteMoves::check(std::uint32_t position, bool mayTakeBack) {
  const ChangedFace& changed = changed_[position];
  const FaceId f = changed.face;
  const VoronoiCircle& now = changed.circle;
  VertexId beyond = kNoVertex;
  if (!hasCircle(position)) {
    if (flipOneOf(f)) return;
  } else if (!now.isHalfPlane() || changed.isFlipped ||
             differByLessThanAQuarter(normalOf(delaunay_->circle(f)), normalOf(now))) {
    HalfedgeId h = kNoHalfedge;
    const Sign order = findDisorder(position, h);
    if (order == Sign::kPositive || (order == Sign::kNegative && flip(h))) return;
    beyond = delaunay_->graph().apex(delaunay_->graph().twin(h));
  }
  if (!mayTakeBack) {
    defer(position);
  } else if (beyond != kNoVertex && isMoved(beyond)) {
    takeBack(beyond);
  } else {
    takeBackOneOf(f);
  }
}

/// Finds the first edge of a face whose ends are not in order, and returns orderOfEnds() of it;
/// positive if there is none. An edge between two faces that change is tested for the first only.
Sign SiteMoves::findDisorder(std::uint32_t position, HalfedgeId& edge) {
  const Graph& graph = delaunay_->graph();
  for (unsigned c = 0; c < 3; ++c) {
    const HalfedgeId h = halfedgeOf(changed_[position].face, c), twin = graph.twin(h);
    const std::uint32_t other = positionOf_[index(faceOf(twin))];
    const bool isFixed = other == kNoIndex || !changed_[other].isActive;
    if (!isFixed && position > other) continue;
    edge = h;
    const VoronoiCircle &left = changed_[position].circle,
                        &right = isFixed ? delaunay_->circle(faceOf(twin)) : changed_[other].circle;
    Sign order = orderOfEnds(h, left, right);
    if (order == Sign::kZero && mostFlips_ > 0 && (isFixed || hasCircle(other)))
      order = exactOrder(h, left, right);
    if (order != Sign::kPositive) return order;
  }
  return Sign::kPositive;
}

/// The first round: faces that have no circle. Where sites have jumped over others, flips by the
/// order along edges alone would tangle the faces further.
void SiteMoves::untangle() {
  for (std::uint32_t position = 0; position < changed_.size(); ++position) {
    if (isTangled(position)) defer(position);
  }
  while (goesOn() && !deferred_.empty()) {
    const std::uint32_t position = deferred_.back();
    deferred_.pop_back();
    changed_[position].isDeferred = false;
    const FaceId f = changed_[position].face;
    if (isTangled(position) && !takeBackCovered(f) && !flipOneOf(f)) takeBackOneOf(f);
  }
}

/// The second round: all faces. Faces with an edge that should be flipped but cannot come last.
void SiteMoves::checkAll() {
  while (goesOn() && !(queue_.empty() && deferred_.empty())) {
    const bool isLast = queue_.empty();
    FlatArray<std::uint32_t>& positions = isLast ? deferred_ : queue_;
    const std::uint32_t position = positions.back();
    positions.pop_back();
    ChangedFace& changed = changed_[position];
    (isLast ? changed.isDeferred : changed.isQueued) = false;
    if (changed.isActive) check(position, isLast || mostFlips_ == 0);
  }
}

/// If one corner covers another, moves the latter back, or the former if the latter is back
/// already.
bool SiteMoves::takeBackCovered(FaceId f) {
  const Graph& graph = delaunay_->graph();
  for (unsigned c = 0; c < 3; ++c) {
    const HalfedgeId h = halfedgeOf(f, c);
    const VertexId i = graph.origin(h), j = graph.target(h);
    if (i == kInfinity || j == kInfinity) continue;
    const bool isICovered = covers(delaunay_->site(j), delaunay_->site(i));
    if (!isICovered && !covers(delaunay_->site(i), delaunay_->site(j))) continue;
    takeBack(isMoved(isICovered ? i : j) ? (isICovered ? i : j) : (isICovered ? j : i));
    return true;
  }
  return false;
}

/// Positive if the ends of the edge dual to h come in order, from the vertex on its right to that
/// on its left; negative if they certainly do not. See the top of the header.
Sign SiteMoves::orderOfEnds(HalfedgeId h, const VoronoiCircle& left,
                            const VoronoiCircle& right) const {
  const Graph& graph = delaunay_->graph();
  const VertexId i = graph.origin(h), j = graph.target(h);
  const bool isSwapped = isBetterReference(delaunay_->corner(j), delaunay_->corner(i));
  const VertexId reference = isSwapped ? j : i;
  const auto turnFrom = [&](const VoronoiCircle& a, const VoronoiCircle& b, const Site& site) {
    const MaybeSign sign = turn(directionOf(a, site), directionOf(b, site));
    return sign.known ? sign.sign : Sign::kZero;
  };
  const Sign now = turnFrom(right, left, delaunay_->site(reference));
  const FaceId leftFace = faceOf(h), rightFace = faceOf(graph.twin(h));
  Sign expected = isSwapped ? Sign::kNegative : Sign::kPositive;
  if ((i == kInfinity || j == kInfinity) && !isFlipped(leftFace) && !isFlipped(rightFace)) {
    expected =
        turnFrom(delaunay_->circle(rightFace), delaunay_->circle(leftFace), siteBefore(reference));
  }
  return expected == now ? (now == Sign::kZero ? now : Sign::kPositive)
         : now == Sign::kZero || expected == Sign::kZero ? Sign::kZero
                                                         : Sign::kNegative;
}

/// The circle of a face with the moves and flips made.
const VoronoiCircle& SiteMoves::circleNow(FaceId f) const {
  const std::uint32_t position = positionOf_[index(f)];
  return position != kNoIndex && changed_[position].isActive ? changed_[position].circle
                                                             : delaunay_->circle(f);
}

bool SiteMoves::isFlipped(FaceId f) const {
  const std::uint32_t position = positionOf_[index(f)];
  return position != kNoIndex && changed_[position].isFlipped;
}

/// Decides the order if the filter does not know it. At infinity only the hull as a whole tells.
Sign SiteMoves::exactOrder(HalfedgeId h, const VoronoiCircle& left, const VoronoiCircle& right) {
  const Graph& graph = delaunay_->graph();
  if (graph.origin(h) == kInfinity || graph.target(h) == kInfinity) {
    if (!areMost()) return Sign::kZero;
    asksHull_ = true;
  }
  return isDelaunayEdge(delaunay_->edge(h), left, right) ? Sign::kPositive : Sign::kNegative;
}

bool SiteMoves::flipOneOf(FaceId f) {
  return flip(halfedgeOf(f, 0)) || flip(halfedgeOf(f, 1)) || flip(halfedgeOf(f, 2));
}

/// Flips the edge if the new faces have circles, and no edge around them gets out of order without
/// being flippable: as the edges of a site of degree 2 that is not between its two neighbours.
bool SiteMoves::flip(HalfedgeId h) {
  if (flips_.size() == mostFlips_) {
    isStuck_ = mostFlips_ > 0;
    return false;
  }
  const Graph& graph = delaunay_->graph();
  const HalfedgeId twin = graph.twin(h);
  const VertexId i = graph.origin(h), j = graph.target(h), k = graph.apex(h), l = graph.apex(twin);
  const bool isAtHull = i == kInfinity || j == kInfinity || k == kInfinity || l == kInfinity;
  if (k == l || (isAtHull && !areMost())) return false;
  VoronoiCircle left, right;
  if (!findCertainVoronoiCircle(delaunay_->corner(l), delaunay_->corner(k), delaunay_->corner(i),
                                left) ||
      !findCertainVoronoiCircle(delaunay_->corner(k), delaunay_->corner(l), delaunay_->corner(j),
                                right))
    return false;
  const FaceId f = faceOf(h), g = faceOf(twin);
  ChangedFace &first = collect(f), &second = collect(g);
  const ChangedFace firstBefore = first, secondBefore = second;
  delaunay_->flip(h);
  first = {f, first.isQueued, first.isDeferred, true, true, left};
  second = {g, second.isQueued, second.isDeferred, true, true, right};
  for (const HalfedgeId side : {next(h), previous(h), next(twin), previous(twin)}) {
    const HalfedgeId outer = graph.twin(side);
    if (graph.apex(side) != graph.apex(outer) ||
        orderOfEnds(side, circleNow(faceOf(side)), circleNow(faceOf(outer))) == Sign::kPositive)
      continue;
    flipBack(*delaunay_, h);
    first = firstBefore;
    second = secondBefore;
    return false;
  }
  flips_.push_back(h);
  asksHull_ |= isAtHull;
  queueAround(f);
  queueAround(g);
  return true;
}

/// Moves a corner of an active face back, or one of a face beyond its edges.
void SiteMoves::takeBackOneOf(FaceId f) {
  const Graph& graph = delaunay_->graph();
  for (const unsigned c : {0u, 1u, 2u}) {
    const VertexId corner = graph.origin(halfedgeOf(f, c));
    if (isMoved(corner)) return takeBack(corner);
  }
  for (const unsigned c : {0u, 1u, 2u}) {
    const VertexId beyond = graph.apex(graph.twin(halfedgeOf(f, c)));
    if (isMoved(beyond)) return takeBack(beyond);
  }
  isStuck_ = true;
}

/// Swaps the circles of changed faces with those in the diagram.
void SiteMoves::swapCircles() noexcept {
  for (ChangedFace& changed : changed_) {
    if (changed.isActive) delaunay_->swapCircle(changed.face, changed.circle);
  }
}

/// Rolls all tried moves back: no face is active, no site is moved.
void SiteMoves::takeBackAll() noexcept {
  for (std::size_t k = 0; k < moves_.size(); ++k) {
    const VertexId v = moves_[k].vertex;
    if (isMoved(v)) delaunay_->setSite(v, before_[k]);
    isMoved_[index(v)] = 0;
  }
  takeFlipsBack(*delaunay_);
  flips_.clear();
}

/// Moves a site back to where it was. Computes the faces around it anew, and queues them and those
/// beyond for checking.
void SiteMoves::takeBack(VertexId v) {
  delaunay_->setSite(v, before_[moveOf_[index(v)]]);
  isMoved_[index(v)] = 0;
  ++left_;
  const Graph& graph = delaunay_->graph();
  for (const HalfedgeId h : graph.star(v)) {
    const std::uint32_t position = positionOf_[index(faceOf(h))];
    computeCircle(position);
    if (mostFlips_ > 0 && isTangled(position)) defer(position);
    queueAround(faceOf(h));
  }
}

/// Queues a face and those beyond its edges.
void SiteMoves::queueAround(FaceId f) {
  queue(f);
  for (unsigned c = 0; c < 3; ++c) queue(faceOf(delaunay_->graph().twin(halfedgeOf(f, c))));
}

void SiteMoves::defer(std::uint32_t position) {
  if (changed_[position].isDeferred) return;
  changed_[position].isDeferred = true;
  deferred_.push_back(position);
}

void SiteMoves::queue(FaceId f) {
  if (positionOf_[index(f)] != kNoIndex) queueAt(positionOf_[index(f)]);
}

void SiteMoves::queueAt(std::uint32_t position) {
  if (changed_[position].isQueued) return;
  changed_[position].isQueued = true;
  queue_.push_back(position);
}

}  // namespace apollonius::internal
