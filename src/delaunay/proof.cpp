#include "delaunay/proof.h"

#include <algorithm>
#include <limits>

#include "delaunay/delaunay_graph.h"
#include "predicate/circle_batch.h"
#include "predicate/compute_circle.h"
#include "predicate/predicates.h"

namespace apollonius::internal {

Proof::Proof(const DelaunayGraph& delaunay, FlatArray<VoronoiCircle>& circles)
    : delaunay_(delaunay), graph_(delaunay.graph()), circles_(circles) {
  circles.resize(graph_.faceSlots());
  if (graph_.isEmpty()) step_ = Step::kHull;
}

bool Proof::advance(std::size_t most) {
  const auto faces = static_cast<std::uint32_t>(graph_.faceSlots());
  const std::uint32_t all = step_ == Step::kFaces ? faces : 3 * faces;
  const auto end = static_cast<std::uint32_t>(next_ + std::min<std::size_t>(most, all - next_));
  switch (step_) {
    case Step::kFaces:
      lookAtFaces(end);
      break;
    case Step::kEdges:
      lookAtEdges(end);
      break;
    case Step::kHull:
      if (!graph_.isEmpty() && !hullTurnsOnce())
        fail("the hull turns more than once: half-edge", graph_.outgoing(kInfinity));
      return true;
  }
  next_ = end;
  if (end == all) {
    step_ = step_ == Step::kFaces ? Step::kEdges : Step::kHull;
    next_ = 0;
  }
  return what_ != nullptr;
}

double Proof::progress() const {
  if (step_ == Step::kHull) return 1;
  const double faces = std::max<double>(1, static_cast<double>(graph_.faceSlots()));
  return step_ == Step::kFaces ? 0.5 * next_ / faces : 0.5 + next_ / (6 * faces);
}

void Proof::fail(const char* what, HalfedgeId h) {
  if (what_ != nullptr) return;
  what_ = what;
  where_ = static_cast<std::uint32_t>(h);
}

/// Filters first: a certain circle proves that it exists and that none of its sites covers another.
void Proof::lookAtFaces(std::uint32_t end) {
  CircleBatch batch([this](std::uint32_t f, const VoronoiCircle& circle) {
    circles_[f] = circle;
    if (!(circle.error < std::numeric_limits<float>::infinity())) lookAtFace(FaceId{f});
  });
  for (std::uint32_t f = next_; f < end && what_ == nullptr; ++f) {
    if (!graph_.isLive(FaceId{f})) continue;
    const EdgeCorners e = delaunay_.edge(halfedgeOf(FaceId{f}, 0));
    if (e.i == nullptr || e.j == nullptr || e.k == nullptr) {
      lookAtFace(FaceId{f});
    } else {
      batch.add(f, {e.i, e.j, e.k});
    }
  }
  batch.finish();
}

void Proof::lookAtFace(FaceId f) {
  for (unsigned c = 0; c < 3; ++c) {
    const HalfedgeId h = halfedgeOf(f, c);
    const Corner i = delaunay_.corner(graph_.origin(h)), j = delaunay_.corner(graph_.target(h));
    if (i == nullptr || j == nullptr || !(covers(*i, *j) || covers(*j, *i))) continue;
    return fail("a visible site is covered by a neighbour: half-edge", h);
  }
  const EdgeCorners e = delaunay_.edge(halfedgeOf(f, 0));
  const bool exists = findVoronoiCircle(e.i, e.j, e.k, circles_[index(f)]);
  if (!exists) fail("a face has no Voronoi circle: half-edge", halfedgeOf(f, 0));
}

void Proof::lookAtEdges(std::uint32_t end) {
  for (std::uint32_t i = next_; i < end && what_ == nullptr; ++i) {
    const HalfedgeId h{i}, twin = graph_.twin(h);
    if (!graph_.isLive(faceOf(h)) || twin < h) continue;  // each edge once
    if (isDelaunayEdge(delaunay_.edge(h), circle(h), circle(twin))) continue;
    fail("the faces of an edge contradict each other: half-edge", h);
  }
}

/// Counts how often the normals pass the angle 0 on their way around infinity.
bool Proof::hullTurnsOnce() const {
  const HalfedgeId begin = graph_.twin(graph_.outgoing(kInfinity));
  HalfedgeId h = begin;  // from i to infinity, between the half-planes of (i, l, infinity) and
                         // (k, i, infinity)
  std::size_t turns = 0;
  do {
    const HalfedgeId twin = graph_.twin(h);
    const Site& i = delaunay_.site(graph_.origin(h));
    const Site &k = delaunay_.site(graph_.apex(h)), &l = delaunay_.site(graph_.apex(twin));
    const bool startsUp = pointsUp(i, l, circle(twin)), endsUp = pointsUp(k, i, circle(h));
    const bool passes = startsUp == endsUp
                            ? turnOfHull(i, l, k, circle(twin), circle(h)) == Sign::kNegative
                            : endsUp;
    turns += static_cast<std::size_t>(passes);
    h = graph_.twin(next(h));
  } while (h != begin);
  return turns == 1;
}

const char* findContradiction(const DelaunayGraph& delaunay, FlatArray<VoronoiCircle>& circles,
                              std::uint32_t& where) {
  Proof proof(delaunay, circles);
  while (!proof.advance(std::numeric_limits<std::size_t>::max())) {
  }
  where = proof.where();
  return proof.contradiction();
}

}  // namespace apollonius::internal
