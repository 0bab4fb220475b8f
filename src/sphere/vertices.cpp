// The plane's circle of a face, mapped back to the sphere, has the plane's rounding, and is
// inaccurate where it is large. So it is only the start of Newton's method for the three equations
//
//     angle(v, u_i) - w_i = clearance
//
// in the two coordinates of v beside its first approximation and the clearance.
#include "sphere/vertices.h"

#include <algorithm>
#include <cmath>

namespace apollonius::internal::sphere {

namespace {

/// The residuals of the three equations.
struct Residuals {
  Residuals(const SphericalVertex& vertex, const std::array<const Cap*, 3>& caps) {
    for (std::size_t k = 0; k < 3; ++k) {
      of[k] = distanceInRadians(vertex.point, *caps[k]) - vertex.clearance;
      largest = std::max(largest, std::abs(of[k]));
    }
  }
  std::array<double, 3> of;
  double largest = 0;
};

bool hasNeedle(const std::array<const Cap*, 3>& caps) {
  return nearlyCovers(*caps[0], *caps[1]) || nearlyCovers(*caps[1], *caps[2]) ||
         nearlyCovers(*caps[2], *caps[0]);
}

}  // namespace

SphericalVertex refined(const SphericalVertex& start, const std::array<const Cap*, 3>& caps) {
  constexpr int kSteps = 4;
  SphericalVertex vertex = start;
  Residuals residuals(vertex, caps);
  for (int step = 0; step < kSteps && residuals.largest > 0x1p-52; ++step) {
    const Frame frame(vertex.point);
    // Going from v by (a, b) changes the distance to site i by -(a, b)·towards[i].
    std::array<std::array<double, 2>, 3> towards;
    for (std::size_t k = 0; k < 3; ++k) {
      const double x = dot(caps[k]->centre, frame.first), y = dot(caps[k]->centre, frame.second);
      const double length = std::hypot(x, y);  // 0 at a centre, or opposite: no direction
      towards[k] = {x / length, y / length};
    }
    const double x1 = towards[1][0] - towards[0][0], y1 = towards[1][1] - towards[0][1];
    const double x2 = towards[2][0] - towards[0][0], y2 = towards[2][1] - towards[0][1];
    const double determinant = x1 * y2 - x2 * y1;
    // Two directions are nearly the same where two sites are close, or one nearly covers another.
    // In the second case rounding moves the vertex farther than a step brings it.
    constexpr double kSteady = 0x1p-20;
    if (std::abs(determinant) < kSteady && hasNeedle(caps)) return vertex;
    const double f1 = residuals.of[1] - residuals.of[0], f2 = residuals.of[2] - residuals.of[0];
    const double a = (f1 * y2 - f2 * y1) / determinant, b = (x1 * f2 - x2 * f1) / determinant;
    if (!(std::abs(a) + std::abs(b) < 0.5)) return vertex;  // too far, or no numbers
    const SphericalVertex next = {
        normalized(vertex.point + a * frame.first + b * frame.second),
        vertex.clearance + residuals.of[0] - a * towards[0][0] - b * towards[0][1]};
    const Residuals after(next, caps);
    if (!(after.largest < residuals.largest)) return vertex;
    vertex = next;
    residuals = after;
  }
  return vertex;
}

SphericalVertices::Entry SphericalVertices::computed(FaceId face) const {
  const DelaunayGraph& plane = diagram_.plane().delaunay();
  const Graph& graph = plane.graph();
  std::array<const Cap*, 3> caps;
  const Site* touched = nullptr;  // the closest to the origin
  const auto square = [](const Site& site) { return site.x * site.x + site.y * site.y; };
  bool isClose = false;  // any two of the sites
  for (unsigned corner = 0; corner < 3; ++corner) {
    const HalfedgeId h = halfedgeOf(face, corner);
    const VertexId node = graph.origin(h);
    isClose |= diagram_.areClose(node, graph.target(h));
    caps[corner] = &diagram_.cap(node);
    if (node == kInfinity) continue;
    const Site& site = plane.site(node);
    if (touched == nullptr || square(site) < square(*touched)) touched = &site;
  }
  const VoronoiCircle circle = plane.voronoiVertex(face);
  const Projection& projection = diagram_.projection();
  const Projection::EmptyCap cap =
      circle.isHalfPlane() ? projection.fromHalfPlane(circle.x, circle.y, *touched)
                           : projection.fromCircle(circle.x, circle.y, circle.s, *touched);
  // Weights were reduced by the pole's.
  const SphericalVertex vertex = {cap.centre, cap.radius - diagram_.cap(kInfinity).weight};
  return {face, kNoFace, isClose ? vertex : refined(vertex, caps), !isClose};
}

std::size_t SphericalVertices::placeOf(FaceId face) const {
  if (isDirect_) return index(face);
  const std::size_t mask = entries_.size() - 1;
  std::size_t at = (index(face) * 0x9E3779B1u) >> 7 & mask;
  while (entries_[at].face != kNoFace && entries_[at].face != face) at = (at + 1) & mask;
  return at;
}

void SphericalVertices::grow() {
  FlatArray<Entry> old(2 * entries_.size());
  old.swap(entries_);
  for (const Entry& entry : old) {
    if (entry.face != kNoFace) entries_[placeOf(entry.face)] = entry;
  }
}

SphericalVertices::Entry& SphericalVertices::entryOf(FaceId face) {
  if (!isDirect_ && 2 * used_ >= entries_.size()) grow();
  Entry& entry = entries_[placeOf(face)];
  if (entry.face == kNoFace) {
    entry = computed(face);
    ++used_;
  }
  return entry;
}

/// All faces that are reached across short edges get the vertex of the first one of them by number.
void SphericalVertices::findSame(FaceId face) {
  constexpr double kShort = 0x1p-42, kLongest = 0x1p-30, kNoise = 0x1p-50;
  const Graph& graph = diagram_.graph();
  // Where two sites are seen in nearly one direction, rounding moves a vertex farther than that,
  // and its distances to the sites by as little as anywhere.
  const auto miss = [&](const Entry& entry, VertexId node) {
    const auto& [point, clearance] = entry.vertex;
    return entry.isRefined ? std::abs(distanceInRadians(point, diagram_.cap(node)) - clearance) : 1;
  };
  reached_.assign(1, face);
  entryOf(face).same = face;  // reached, until all are known
  FaceId first = face;
  for (std::size_t k = 0; k < reached_.size(); ++k) {
    const Entry one = entryOf(reached_[k]);
    for (unsigned corner = 0; corner < 3; ++corner) {
      const HalfedgeId h = halfedgeOf(one.face, corner), twin = graph.twin(h);
      const FaceId beyond = faceOf(twin);
      Entry& entry = entryOf(beyond);
      if (entry.same != kNoFace) continue;
      const double length = lengthOf(entry.vertex.point - one.vertex.point);
      const bool isShort = length <= kShort ||
                           (length <= kLongest && std::min(miss(one, graph.apex(twin)),
                                                           miss(entry, graph.apex(h))) <= kNoise);
      if (!isShort) continue;
      entry.same = face;
      reached_.push_back(beyond);
      if (index(beyond) < index(first)) first = beyond;
    }
  }
  for (const FaceId one : reached_) entryOf(one).same = first;
}

const SphericalVertex& SphericalVertices::operator[](FaceId face) {
  FaceId same = entryOf(face).same;
  if (same == kNoFace) {
    findSame(face);
    same = entryOf(face).same;
  }
  return entries_[placeOf(same)].vertex;
}

}  // namespace apollonius::internal::sphere
