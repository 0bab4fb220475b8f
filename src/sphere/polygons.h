// The cells of the sphere as polygons of longitudes and latitudes.
#pragma once

#include <span>

#include "sphere/antimeridian.h"
#include "sphere/cell.h"
#include "sphere/chain.h"

namespace apollonius::internal::sphere {

/// Writes the cells of sites, within a tolerance in radians. The cells of all sites have the points
/// of each edge in common. Calls throw std::bad_alloc.
class CellPolygons {
 public:
  /// Points are joined by arcs of great circles, or, cut at the meridian of 180 degrees, by
  /// straight lines of the plane of longitude and latitude.
  CellPolygons(const ProjectedDiagram& diagram, double tolerance, bool isCut,
               const AngularReach& reach, SphericalVertices::Of of);

  /// Appends the cell of a visible site: one ring with the cell on its left, none if it is the
  /// whole sphere, or, if cells are cut, the rings of one part or more; nothing if its reach does
  /// not go beyond its centre.
  void append(VertexId node);

  [[nodiscard]] const LonLatRings& rings() const { return rings_; }

 private:
  /// Writes the boundary to points_: parts of edges, and of the circle at the angle `reach`.
  void followWithin(VertexId node, double reach);
  /// Removes the spurs of the boundary in points_, and returns the rest. A spur goes to a point and
  /// back the same way, as around a cell without width.
  [[nodiscard]] std::span<const MapPoint> withoutSpurs();

  const ProjectedDiagram& diagram_;
  AngularReach reach_;
  ChainMaker chains_;
  bool isCut_;
  LonLatRings rings_;
  FlatArray<MapPoint> points_;
  FlatArray<Sector> sectors_;
  FlatArray<ChainMaker::Strand> strands_;
  FlatArray<MapPoint> inner_;  // points of the strands
  AntimeridianCutter cutter_;
};

}  // namespace apollonius::internal::sphere
