#include "delaunay/moves.h"

#include <algorithm>
#include <limits>

#include "predicate/circle_batch.h"
#include "predicate/compute_circle.h"
#include "predicate/direction.h"
#include "predicate/reference_site.h"

namespace apollonius::internal {

namespace {

/// Of a half-plane.
Arrow normalOf(const VoronoiCircle& circle) { return {circle.x, circle.y, circle.slope}; }

}  // namespace

std::span<const std::uint8_t> SiteMoves::apply(DelaunayGraph& delaunay, std::span<const Move> moves,
                                               std::size_t mostLeft) {
  delaunay_ = &delaunay;
  moves_ = moves;
  reserveMoves(delaunay);
  isMade_.assign(moves.size(), 0);
  if (areHopeless(mostLeft)) return {isMade_.data(), moves.size()};
  reserveFaces(delaunay.graph());
  collectFaces();
  makeAll();
  // The new circles, then the checks; a face that fails makes a site go back, and the faces around
  // are checked again. In the end all that moved passes, and what went back is as it was.
  computeCircles();
  for (std::uint32_t position = 0; position < changed_.size() && left_ <= mostLeft; ++position)
    check(position);
  while (!queue_.empty() && left_ <= mostLeft) {
    const std::uint32_t position = queue_.back();
    queue_.pop_back();
    check(position);
  }
  if (left_ > mostLeft) takeBackAll();
  for (const ChangedFace& changed : changed_) {
    if (changed.isActive) delaunay.setCircle(changed.face, changed.circle);
    positionOf_[index(changed.face)] = kNoIndex;
  }
  for (std::size_t k = 0; k < moves.size(); ++k) {
    isMade_[k] = isMoved_[index(moves[k].vertex)];
    isMoved_[index(moves[k].vertex)] = 0;
  }
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

void SiteMoves::reserveFaces(const Graph& graph) {
  if (positionOf_.size() < graph.faceSlots()) positionOf_.resize(graph.faceSlots(), kNoIndex);
  std::size_t faces = moves_.size() * 8 < graph.faceCount()
                          ? 0
                          : graph.faceCount();  // all, or those that there are
  if (faces == 0) {
    for (const Move& move : moves_) {
      for ([[maybe_unused]] const HalfedgeId h : graph.star(move.vertex)) ++faces;
    }
    faces = std::min(faces, graph.faceCount());
  }
  changed_.clear();
  changed_.reserve(faces);
  queue_.clear();
  queue_.reserve(faces);  // a face is in the queue once
}

void SiteMoves::collectFaces() {
  const Graph& graph = delaunay_->graph();
  for (const Move& move : moves_) {
    for (const HalfedgeId h : graph.star(move.vertex)) {
      std::uint32_t& position = positionOf_[index(faceOf(h))];
      if (position != kNoIndex) continue;
      position = static_cast<std::uint32_t>(changed_.size());
      changed_.push_back({faceOf(h), true, true, {}});
      // If it is missing, it is computed of the sites as they are now.
      (void)delaunay_->circle(faceOf(h));
    }
  }
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
}

/// Would too many have to stay? The share of sites whose own faces contradict each other after the
/// moves is a good guess at that of those that have to stay in the end. A sample of them costs some
/// percent of all.
bool SiteMoves::areHopeless(std::size_t mostLeft) {
  constexpr std::size_t kShare = 16, kMost = 256;
  const std::size_t sample = std::min(moves_.size() / kShare, kMost);
  if (moves_.size() <= mostLeft || sample < kShare) return false;
  delaunay_->computeMissingCircles();  // of the sites as they are now
  makeAll();
  std::size_t failing = 0;
  for (std::size_t k = 0; k < sample; ++k)
    failing += !keepsItsStar(moves_[k * moves_.size() / sample].vertex);
  takeBackAll();
  return failing * moves_.size() > mostLeft * sample;
}

/// Have all faces around it circles, and are their vertices in order along its edges?
bool SiteMoves::keepsItsStar(VertexId v) const {
  const Graph& graph = delaunay_->graph();
  const HalfedgeId begin = graph.outgoing(v);
  VoronoiCircle first, before, now;
  for (const HalfedgeId h : graph.star(v)) {
    const EdgeCorners e = delaunay_->edge(h);
    if (!findCertainVoronoiCircle(e.i, e.j, e.k, now)) return false;
    if (h == begin) {
      first = now;
    } else if (graph.target(h) != kInfinity && !endsAreInOrder(h, now, before)) {
      return false;
    }
    before = now;
  }
  return graph.target(begin) == kInfinity || endsAreInOrder(begin, first, before);
}

const Site& SiteMoves::siteBefore(VertexId v) const {
  return isMoved(v) ? before_[moveOf_[index(v)]] : delaunay_->site(v);
}

bool SiteMoves::hasMovedCorner(FaceId f) const {
  const Graph& graph = delaunay_->graph();
  return isMoved(graph.origin(halfedgeOf(f, 0))) || isMoved(graph.origin(halfedgeOf(f, 1))) ||
         isMoved(graph.origin(halfedgeOf(f, 2)));
}

/// All faces have moved corners.
void SiteMoves::computeCircles() {
  const Graph& graph = delaunay_->graph();
  CircleBatch batch([this](std::uint32_t position, const VoronoiCircle& circle) {
    changed_[position].circle = circle;
    if (!(circle.error < std::numeric_limits<float>::infinity())) computeCircle(position);
  });
  for (std::uint32_t position = 0; position < changed_.size(); ++position) {
    const HalfedgeId h = halfedgeOf(changed_[position].face, 0);
    const Corner i = delaunay_->corner(graph.origin(h)), j = delaunay_->corner(graph.target(h)),
                 k = delaunay_->corner(graph.apex(h));
    if (i == nullptr || j == nullptr || k == nullptr) {
      computeCircle(position);
    } else {
      batch.add(position, {i, j, k});
    }
  }
  batch.finish();
}

void SiteMoves::computeCircle(std::uint32_t position) {
  ChangedFace& changed = changed_[position];
  changed.isActive = hasMovedCorner(changed.face);
  if (!changed.isActive) return;
  const EdgeCorners e = delaunay_->edge(halfedgeOf(changed.face, 0));
  if (!findCertainVoronoiCircle(e.i, e.j, e.k, changed.circle))
    changed.circle.error = std::numeric_limits<float>::infinity();
}

/// The conditions for one face: its circle exists, its vertex comes in order along its edges, and
/// if it is at infinity, its normal has turned by less than a quarter.
void SiteMoves::check(std::uint32_t position) {
  ChangedFace& changed = changed_[position];
  changed.isQueued = false;
  const FaceId f = changed.face;
  if (!changed.isActive) return;
  const VoronoiCircle &before = delaunay_->circle(f), &now = changed.circle;
  if (!(now.error < std::numeric_limits<float>::infinity()) ||
      (now.isHalfPlane() && !differByLessThanAQuarter(normalOf(before), normalOf(now)))) {
    takeBackOneOf(f);
    return;
  }
  const Graph& graph = delaunay_->graph();
  for (unsigned c = 0; c < 3; ++c) {
    const HalfedgeId h = halfedgeOf(f, c), twin = graph.twin(h);
    const std::uint32_t other = positionOf_[index(faceOf(twin))];
    const bool isFixed = other == kNoIndex || !changed_[other].isActive;
    if (!isFixed && position > other) continue;  // asked from the other side
    if (endsAreInOrder(h, now, isFixed ? delaunay_->circle(faceOf(twin)) : changed_[other].circle))
      continue;
    if (const VertexId beyond = graph.apex(twin); isMoved(beyond)) {
      takeBack(beyond);
    } else {
      takeBackOneOf(f);
    }
    return;
  }
}

/// Of the edge dual to h, from the vertex on its right to that on its left: do they come in this
/// order? See the top of the header.
bool SiteMoves::endsAreInOrder(HalfedgeId h, const VoronoiCircle& left,
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
  if (i != kInfinity && j != kInfinity)
    return now == (isSwapped ? Sign::kNegative : Sign::kPositive);
  return now != Sign::kZero && now == turnFrom(delaunay_->circle(faceOf(graph.twin(h))),
                                               delaunay_->circle(faceOf(h)), siteBefore(reference));
}

/// A corner of an active face.
void SiteMoves::takeBackOneOf(FaceId f) {
  const Graph& graph = delaunay_->graph();
  for (unsigned c = 0; c < 3; ++c) {
    const VertexId corner = graph.origin(halfedgeOf(f, c));
    if (isMoved(corner)) return takeBack(corner);
  }
}

/// As if nothing had been tried: no face is active, no site is moved.
void SiteMoves::takeBackAll() noexcept {
  for (std::size_t k = 0; k < moves_.size(); ++k) {
    const VertexId v = moves_[k].vertex;
    if (isMoved(v)) delaunay_->setSite(v, before_[k]);
    isMoved_[index(v)] = 0;
  }
  for (ChangedFace& changed : changed_) changed.isActive = false;
}

/// The site returns to where it was; the faces around it are computed anew, and they and the ones
/// beyond are to be checked.
void SiteMoves::takeBack(VertexId v) {
  delaunay_->setSite(v, before_[moveOf_[index(v)]]);
  isMoved_[index(v)] = 0;
  ++left_;
  const Graph& graph = delaunay_->graph();
  for (const HalfedgeId h : graph.star(v)) {
    computeCircle(positionOf_[index(faceOf(h))]);
    for (unsigned c = 0; c < 3; ++c) queue(faceOf(graph.twin(halfedgeOf(faceOf(h), c))));
    queue(faceOf(h));
  }
}

void SiteMoves::queue(FaceId f) {
  const std::uint32_t position = positionOf_[index(f)];
  if (position == kNoIndex || changed_[position].isQueued) return;
  changed_[position].isQueued = true;
  queue_.push_back(position);
}

}  // namespace apollonius::internal
