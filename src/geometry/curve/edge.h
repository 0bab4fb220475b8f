// A Voronoi edge as a curve: its bisector, and where it ends on it. Taken from the Delaunay graph
// and the circles of its faces.
#pragma once

#include <limits>

#include "base/flat_array.h"
#include "delaunay/delaunay_graph.h"
#include "geometry/curve/bisector.h"
#include "number/fp.h"

namespace apollonius::internal {

/// An end of an edge: a Voronoi vertex, or infinity (also if the vertex is beyond the range of
/// doubles).
struct EdgeEnd {
  Point point;
  bool isFinite = false;
};

/// Is a circle a half-plane, or has it an error bound of at most this share of its numbers?
[[nodiscard]] inline bool isKnownWithin(const VoronoiCircle& circle, double share) {
  return circle.isHalfPlane() ||
         (circle.error < std::numeric_limits<float>::infinity() &&
          circle.error <= share * (absolute(circle.x) + absolute(circle.y) + absolute(circle.s)));
}
/// Is a face's cached circle as good as preciseVoronoiCircle's? For drawings and quick tests; its
/// last bits depend on the history.
[[nodiscard]] inline bool isPrecise(const VoronoiCircle& circle) {
  return isKnownWithin(circle, powerOfTwo(-40));
}

/// The precision of a vertex. kReproducible: the same bits after any history
/// (DelaunayGraph::voronoiVertex). kFast: the cached circle if it is precise, which is quicker and
/// differs in the last places. kRough: the cached circle if it is off by at most 2^-30 of its
/// numbers, for intermediate measures.
enum class VertexPrecision : unsigned char { kReproducible, kFast, kRough };

/// Vertices that have been computed, for the other two edges of each: by face, the last of those
/// with the same remainder.
struct KeptVertex {
  EdgeEnd vertex;
  FaceId face{0xFFFFFFFFu};
};
using KeptVertices = FlatArray<KeptVertex>;

/// The Voronoi vertex of a face.
[[nodiscard]] EdgeEnd endAt(const DelaunayGraph& delaunay, FaceId f, VertexPrecision precision);

/// The half-edge of an edge whose origin is the reference site of its bisector: the larger one in
/// the order of precedes(). REQUIRES: two finite sites.
[[nodiscard]] bool startsAtReference(const DelaunayGraph& delaunay, HalfedgeId h);

/// The edge dual to h, from E = e0 (the vertex of the face to the right of h) to e1 >= e0. Its ends
/// are taken as they are, whatever their rounding: the edges that meet in a vertex have exactly
/// that point in common.
struct Edge {
  Bisector bisector;
  EdgeEnd from, to;
  double e0, e1;

  /// Between two ends of the bisector, counter-clockwise about its reference site.
  Edge(const Bisector& curve, EdgeEnd start, EdgeEnd end);
  /// REQUIRES: startsAtReference; vertices that are kept have the same precision.
  Edge(const DelaunayGraph& delaunay, HalfedgeId h,
       VertexPrecision precision = VertexPrecision::kReproducible, KeptVertices* kept = nullptr);
};

/// A piece of an edge between two places, with these ends. Straight where rounding has exchanged
/// the two, or where doubles know no curve.
[[nodiscard]] Conic pieceOf(const Bisector& bisector, double e0, double e1, Point from, Point to);
/// Is a piece no longer than rounding moves its ends? Then, if it ends at something other than a
/// vertex, the edge merely touches that.
[[nodiscard]] bool isTouch(const Bisector& bisector, const Conic& piece);

}  // namespace apollonius::internal
