#include "diagram/site_moves.h"

#include <algorithm>
#include <limits>

#include "predicate/direction.h"

namespace apollonius {

std::span<const std::uint8_t> SiteMoves::apply(DelaunayGraph& diagram, std::span<const Move> moves) {
  diagram_ = &diagram;
  moves_ = moves;
  reserve(diagram, moves.size());
  collectFaces();
  for (std::uint32_t k = 0; k < moves.size(); ++k) {
    const VertexId v = moves[k].vertex;
    before_[k] = diagram.site(v);
    diagram.setSite(v, moves[k].to);
    moveOf_[index(v)] = k;
    isMoved_[index(v)] = 1;
  }
  // The new circles, then the checks; a face that fails makes its sites go back, and the faces around are checked again. In the end
  // all that moved passes, and what went back is as it was.
  for (std::uint32_t position = 0; position < changed_.size(); ++position) computeCircle(position);
  for (std::uint32_t position = 0; position < changed_.size(); ++position) check(position);
  while (!queue_.empty()) {
    const std::uint32_t position = queue_.back();
    queue_.pop_back();
    check(position);
  }
  for (const ChangedFace& changed : changed_) {
    if (changed.isActive) diagram.circles_[index(changed.face)] = changed.circle;
    positionOf_[index(changed.face)] = kNoIndex;
  }
  for (std::size_t k = 0; k < moves.size(); ++k) {
    isMade_[k] = isMoved_[index(moves[k].vertex)];
    isMoved_[index(moves[k].vertex)] = 0;
  }
  return {isMade_.data(), moves.size()};
}

void SiteMoves::reserve(const DelaunayGraph& diagram, std::size_t moves) {
  const Graph& graph = diagram.graph();
  before_.resize(moves);
  isMade_.resize(moves);
  if (isMoved_.size() < graph.vertexSlots()) {
    moveOf_.resize(graph.vertexSlots());
    isMoved_.resize(graph.vertexSlots(), 0);
  }
  if (positionOf_.size() < graph.faceSlots()) positionOf_.resize(graph.faceSlots(), kNoIndex);
  std::size_t faces = 0;
  for (const Move& move : moves_) {
    const HalfedgeId begin = graph.outgoing(move.vertex);
    HalfedgeId h = begin;
    do {
      ++faces;
      h = graph.rotateCcw(h);
    } while (h != begin);
  }
  faces = std::min(faces, graph.faceCount());
  changed_.clear();
  changed_.reserve(faces);
  queue_.clear();
  queue_.reserve(faces);  // a face is in the queue once
}

void SiteMoves::collectFaces() {
  const Graph& graph = diagram_->graph();
  for (const Move& move : moves_) {
    const HalfedgeId begin = graph.outgoing(move.vertex);
    HalfedgeId h = begin;
    do {
      std::uint32_t& position = positionOf_[index(faceOf(h))];
      if (position == kNoIndex) {
        position = static_cast<std::uint32_t>(changed_.size());
        changed_.push_back({faceOf(h), true, true, {}});
      }
      h = graph.rotateCcw(h);
    } while (h != begin);
  }
}

const Site& SiteMoves::siteBefore(VertexId v) const { return isMoved(v) ? before_[moveOf_[index(v)]] : diagram_->site(v); }

bool SiteMoves::hasMovedCorner(FaceId f) const {
  const Graph& graph = diagram_->graph();
  return isMoved(graph.origin(halfedgeOf(f, 0))) || isMoved(graph.origin(halfedgeOf(f, 1))) || isMoved(graph.origin(halfedgeOf(f, 2)));
}

void SiteMoves::computeCircle(std::uint32_t position) {
  ChangedFace& changed = changed_[position];
  changed.isActive = hasMovedCorner(changed.face);
  if (!changed.isActive) return;
  const EdgeCorners e = diagram_->edge(halfedgeOf(changed.face, 0));
  if (!findCertainVoronoiCircle(e.i, e.j, e.k, changed.circle)) changed.circle.error = std::numeric_limits<float>::infinity();
}

/// The conditions for one face: its circle exists, no corner beyond an edge is in conflict with it nor one of its corners
/// with the face beyond, and its vertex has turned by less than a quarter as seen from each corner.
void SiteMoves::check(std::uint32_t position) {
  ChangedFace& changed = changed_[position];
  changed.isQueued = false;
  const FaceId f = changed.face;
  if (!changed.isActive) return;
  const VoronoiCircle &before = diagram_->circle(f), &now = changed.circle;
  if (!(now.error < std::numeric_limits<float>::infinity()) || before.isHalfPlane() != now.isHalfPlane()) {
    takeBackCorners(f);
    return;
  }
  const Graph& graph = diagram_->graph();
  const auto isClear = [&](const VoronoiCircle& circle, VertexId v) {
    if (v == kInfinity) return true;  // a circle that exists is nearer than infinity
    const MaybeSign filtered = circleFilter(circle, diagram_->site(v));
    return filtered.known && filtered.sign == Sign::kNegative;
  };
  for (unsigned c = 0; c < 3; ++c) {
    const HalfedgeId h = halfedgeOf(f, c), twin = graph.twin(h);
    const VertexId corner = graph.origin(h), beyond = graph.apex(twin), apex = graph.apex(h);
    if (corner != kInfinity && !differByLessThanAQuarter(directionOf(before, siteBefore(corner)), directionOf(now, diagram_->site(corner)))) {
      takeBackCorners(f);
      return;
    }
    // An active face beyond asks about this one's corner itself.
    const std::uint32_t other = positionOf_[index(faceOf(twin))];
    const bool isFixed = other == kNoIndex || !changed_[other].isActive;
    if (beyond == apex || !isClear(now, beyond) || (isFixed && !isClear(diagram_->circle(faceOf(twin)), apex))) {
      takeBackCorners(f);
      if (isMoved(beyond)) takeBack(beyond);
      return;
    }
  }
}

void SiteMoves::takeBackCorners(FaceId f) {
  const Graph& graph = diagram_->graph();
  for (unsigned c = 0; c < 3; ++c) {
    const VertexId corner = graph.origin(halfedgeOf(f, c));
    if (isMoved(corner)) takeBack(corner);
  }
}

/// The site returns to where it was; the faces around it are computed anew, and they and the ones beyond are to be checked.
void SiteMoves::takeBack(VertexId v) {
  diagram_->setSite(v, before_[moveOf_[index(v)]]);
  isMoved_[index(v)] = 0;
  const Graph& graph = diagram_->graph();
  const HalfedgeId begin = graph.outgoing(v);
  HalfedgeId h = begin;
  do {
    computeCircle(positionOf_[index(faceOf(h))]);
    for (unsigned c = 0; c < 3; ++c) queue(faceOf(graph.twin(halfedgeOf(faceOf(h), c))));
    queue(faceOf(h));
    h = graph.rotateCcw(h);
  } while (h != begin);
}

void SiteMoves::queue(FaceId f) {
  const std::uint32_t position = positionOf_[index(f)];
  if (position == kNoIndex || changed_[position].isQueued) return;
  changed_[position].isQueued = true;
  queue_.push_back(position);
}

}  // namespace apollonius
