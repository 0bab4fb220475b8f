// Cells of the sphere as polygons of longitudes and latitudes.
#pragma once

#include <cstdint>
#include <vector>

#include "sphere/antimeridian.h"
#include "sphere/chain.h"

namespace apollonius::internal {

/// Polygons one after the other. All start with the first element, 0.
struct SphericalRings {
  std::vector<double>& coordinates;  ///< longitude, latitude of each point; rings are closed
  std::vector<std::uint32_t>& starts;
  std::vector<std::uint32_t>& parts;
};

/// Writes the cells of sites, within a tolerance in radians. The cells of all sites have the points
/// of each edge in common. Calls throw std::bad_alloc.
class CellPolygons {
 public:
  /// Points are joined by arcs of great circles, or, cut at the meridian of 180 degrees, by
  /// straight lines of the plane of longitude and latitude.
  CellPolygons(const ProjectedDiagram& diagram, double tolerance, bool isCut);

  /// Appends the cell of a visible site: one ring that has it at the left, none if it is the whole
  /// sphere, or, where it is cut, rings of one part or more.
  void append(VertexId node, const SphericalRings& rings);

 private:
  const ProjectedDiagram& diagram_;
  ChainMaker chains_;
  bool isCut_;
  VertexId atNorthPole_;
  FlatArray<Direction> points_;
  AntimeridianCutter cutter_;
};

}  // namespace apollonius::internal
