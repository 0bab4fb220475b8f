// The edges of the sphere as chains of points, which are the same for both cells.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>

#include "base/flat_array.h"
#include "base/function_ref.h"
#include "sphere/cell.h"

namespace apollonius::internal::sphere {

/// The lines between the points of a chain: arcs of great circles on the sphere, or straight lines
/// in the plane of longitude and latitude.
enum class Joint : unsigned char { kGreatArc, kLonLatLine };

/// Calls throw std::bad_alloc.
class ChainMaker {
 public:
  /// Chains are within `tolerance`, in radians; the lines of a map are within the same angle in
  /// degrees.
  ChainMaker(const ProjectedDiagram& diagram, double tolerance, Joint joint,
             SphericalVertices::Of of)
      : diagram_(diagram), vertices_(diagram, of), tolerance_(tolerance), joint_(joint) {
    if (of == SphericalVertices::Of::kSome) return;
    chains_.resize(3 * diagram.graph().faceSlots());
    places_.resize(diagram.graph().faceSlots(), {0, kUnknown});
  }

  /// Appends the points of a site's edge, counter-clockwise about it, without the last one. The
  /// site is the origin of h.
  void append(HalfedgeId h, FlatArray<MapPoint>& points);

  /// A part of a site's edge within its reach: the points from `begin` to before `end`, both ends
  /// of the part included, and the bearings of these ends, counted from the beginning of the site's
  /// sector.
  struct Strand {
    std::size_t begin, end;
    double from, to;
  };
  /// Appends the parts of a site's edge within its reach, and their points. The points where the
  /// edge leaves the reach of either site are among them. `sector` is that of h about its origin.
  void appendWithin(HalfedgeId h, const Sector& sector, const AngularReach& reach,
                    FlatArray<MapPoint>& points, FlatArray<Strand>& strands);
  /// Appends the parts within the reach of the closed edge of one of two visible sites. Its sector
  /// begins where the edge is farthest.
  void appendClosedWithin(VertexId node, const Sector& sector, const AngularReach& reach,
                          FlatArray<MapPoint>& points, FlatArray<Strand>& strands);
  /// Appends the points of a circle about a site, at the angle `reach`, between two of its points:
  /// `first` at the bearing `from`, and `last` at from + width.
  void appendCircle(VertexId node, double reach, const MapPoint& first, double from, double width,
                    const MapPoint& last, FlatArray<MapPoint>& points);
  /// The point at a bearing about a site, at the angle `reach`.
  [[nodiscard]] MapPoint onCircle(VertexId node, double reach, double bearing) const;
  [[nodiscard]] SphericalVertices& vertices() { return vertices_; }

 private:
  /// Is the edge followed from this site? The other site gets the same points in reverse.
  [[nodiscard]] bool isFollowedFrom(VertexId node, VertexId neighbor) const;
  struct Edge;
  void appendWithin(const Edge& edge, VertexId node, const Sector& sector,
                    const AngularReach& reach, FlatArray<MapPoint>& points,
                    FlatArray<Strand>& strands);
  /// How close a piece is to its curve. kRadial: it goes straight away from the site, so that the
  /// curve can be met anywhere on it, and is a great-circle arc up to rounding.
  enum class Fit : unsigned char { kCoarse, kFine, kRadial };
  using PointAt = FunctionRef<MapPoint(double)>;
  using FitOf = FunctionRef<Fit(const MapPoint&, const MapPoint&)>;
  /// For curves that only have to be tested at their middle.
  static constexpr auto kIsFine = [](const MapPoint&, const MapPoint&) { return Fit::kFine; };
  /// Appends the points between the ends of a curve that turns by `width`; pointAt(part) is its
  /// point at a part from 0 to 1. Pieces are halved until they are close to the curve at their
  /// middle and by fitOf(a, b).
  void subdivide(double width, const MapPoint& first, const MapPoint& last, PointAt pointAt,
                 FitOf fitOf, FlatArray<MapPoint>& points);
  /// Appends the points between the ends of an arc of a great circle, shorter than a quarter.
  void appendArc(const MapPoint& a, const MapPoint& b, FlatArray<MapPoint>& points);
  /// Appends the points between the ends of a part of an edge.
  void follow(const Edge& edge, double from, double to, const MapPoint& first, const MapPoint& last,
              FlatArray<MapPoint>& points);
  /// The points between the ends of an edge that is followed from the origin of h. Valid until the
  /// next call.
  [[nodiscard]] std::span<const MapPoint> innerOf(HalfedgeId h, const MapPoint& first,
                                                  const MapPoint& last);
  /// A point of a chain; its place on the map is computed at once if the joints need it.
  [[nodiscard]] MapPoint shown(const Direction& point) const;
  void locate(MapPoint& point) const;
  [[nodiscard]] const MapPoint& vertexOf(FaceId face);
  /// Is a piece also close to the edge in the direction of the middle of its chord? An edge that
  /// comes from afar and turns beside the site may have reached the turn already at half the angle.
  [[nodiscard]] Fit fitAtChord(const Edge& edge, const MapPoint& a, const MapPoint& b) const;
  /// Is a piece close to the bisector in a direction from the site?
  [[nodiscard]] Fit fitTowards(const SphericalBisector& bisector, const Direction& centre,
                               const Frame& frame, double x, double y, const MapPoint& a,
                               const MapPoint& b) const;
  /// Do its two ends suffice for an edge that is followed from `node`? A filter without
  /// trigonometry, which recognizes most such edges.
  [[nodiscard]] bool isOnePiece(VertexId node, VertexId neighbor, const MapPoint& from,
                                const MapPoint& to) const;
  [[nodiscard]] bool isFine(const MapPoint& a, const MapPoint& middle, const MapPoint& b) const;
  /// Is a piece so short that its direction and its bend are rounding, or, on a map, as short as
  /// the distance within which points are moved to a pole? Halving it would not end.
  [[nodiscard]] bool isShort(const Direction& a, const Direction& middle, const Direction& b) const;
  /// Is a piece so long that an S-shaped curve about it, as at the equator of a map, could be
  /// farther away than the tolerance? The middle of such a curve is on the piece.
  [[nodiscard]] bool mayTurnBack(const MapPoint& a, const MapPoint& b) const;

  const ProjectedDiagram& diagram_;
  SphericalVertices vertices_;
  double tolerance_;
  Joint joint_;
  // The vertices of the previous edge: one of them belongs to the next one, too.
  std::array<std::pair<FaceId, MapPoint>, 2> vertexPoints_{{{kNoFace, {}}, {kNoFace, {}}}};
  FlatArray<MapPoint> ends_;   // ends of the pieces that are still to be followed
  FlatArray<MapPoint> inner_;  // points between the ends of the last edge
  FlatArray<double> parts_;    // scratch of appendWithin()
  FlatArray<double> cuts_;     // likewise
  // If all cells are listed, each edge is needed twice: its points are kept by half-edge, about 40
  // MB at most.
  struct Chain {
    std::uint32_t begin = 0, count = 0;
    bool isKnown = false;
  };
  static constexpr std::size_t kMostKept = std::size_t{1} << 20;
  FlatArray<Chain> chains_;
  // Each vertex is needed three times: its place on the map, by face.
  static constexpr double kUnknown = 1000;  // no latitude
  FlatArray<LonLat> places_;
  FlatArray<MapPoint> kept_;
};

}  // namespace apollonius::internal::sphere
