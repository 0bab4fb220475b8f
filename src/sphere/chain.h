// Edges of the sphere as chains of points, the same for both cells.
#pragma once

#include "base/flat_array.h"
#include "sphere/cell.h"

namespace apollonius::internal::sphere {

/// What joins the points of a chain: arcs of great circles on the sphere, or, in the plane of
/// longitude and latitude, straight lines.
enum class Joint : unsigned char { kGreatArc, kLonLatLine };

/// Calls throw std::bad_alloc.
class ChainMaker {
 public:
  /// Within a tolerance in radians, or of straight lines the same in degrees.
  ChainMaker(const ProjectedDiagram& diagram, double tolerance, Joint joint,
             SphericalVertices::Of of)
      : diagram_(diagram), vertices_(diagram, of), tolerance_(tolerance), joint_(joint) {}

  /// Appends the points of a site's edge, counter-clockwise about it, without the last one. The
  /// site is the origin of h.
  void append(HalfedgeId h, FlatArray<Direction>& points);
  /// The closed edge of a site, where there are two visible sites.
  void appendClosed(VertexId node, FlatArray<Direction>& points);
  [[nodiscard]] SphericalVertices& vertices() { return vertices_; }

 private:
  /// Is the edge followed from this site? The other one gets the same points in reverse.
  [[nodiscard]] bool isFollowedFrom(VertexId node, VertexId neighbor) const;
  void follow(VertexId node, VertexId neighbor, const Sector& sector, const Direction& first,
              const Direction& last, FlatArray<Direction>& points) const;
  /// A point as it is written.
  [[nodiscard]] Direction shown(const Direction& point) const;
  /// Can its ends alone stand for an edge, which is followed from `node`? A filter without
  /// trigonometry, which knows most of them.
  [[nodiscard]] bool isOnePiece(VertexId node, VertexId neighbor, const Direction& first,
                                const Direction& last) const;
  [[nodiscard]] bool isFine(const Direction& a, const Direction& middle, const Direction& b) const;

  const ProjectedDiagram& diagram_;
  SphericalVertices vertices_;
  double tolerance_;
  Joint joint_;
};

}  // namespace apollonius::internal::sphere
