// Natural neighbours (Sibson) on the sphere: from whose cells a new site would take something, and
// which share of its own cell from each.
//
// Nothing is inserted. As seen from the centre of a site, the bisector with the new one is a curve
// like those with its neighbours; where it is the nearest of them, the area between it and the next
// nearest belongs to the new cell (sphere/bisector.h). The parts of present edges in the new cell
// are connected, so the neighbours are found from the nearest site across them.
#pragma once

#include <span>

#include "base/flat_array.h"
#include "diagram/nearby_search.h"
#include "sphere/cell.h"
#include "sphere/site_table.h"

namespace apollonius::internal::sphere {

/// The share of the new cell that it takes from a site's cell.
struct NaturalShare {
  VertexId node;
  double weight;
};

/// Finds natural neighbours. Keeps its memory from one cap to the next. Calls throw std::bad_alloc.
class NaturalNeighbors {
 public:
  /// The diagram must stay as it is.
  NaturalNeighbors(const ProjectedDiagram& diagram, SphericalVertices::Of of)
      : diagram_(diagram), vertices_(diagram, of) {}

  /// Finds the natural neighbours of a cap: the weights are positive and add up to 1. A site that
  /// covers it is the only one, and so is the nearest site if the cap's cell is too thin for
  /// doubles. REQUIRES: there are sites. Valid until the next call. Cost: one location and O(size
  /// of what would change).
  [[nodiscard]] std::span<const NaturalShare> find(const Cap& cap);

 private:
  /// The area that the cap takes from a node's cell. Notes the neighbours across whose edges the
  /// new cell extends.
  [[nodiscard]] double areaTaken(VertexId node, const Cap& cap);
  /// Calls visit(sector, neighbor) for each of sectors_, which are the node's.
  template <class Visit>
  void visitEdges(VertexId node, Visit&& visit) const;
  void note(VertexId node);

  const ProjectedDiagram& diagram_;
  SphericalVertices vertices_;
  FlatArray<NaturalShare> shares_;
  FlatArray<Sector> sectors_;  // scratch
  FlatArray<VertexId> reached_;
  SlotSet seen_;  // by site
};

/// Interpolates a field at the points longitude, latitude in degrees: sums up the values, given by
/// id, of the natural neighbours of a new site with the weight `weight`, in radians. NaN without
/// sites. Throws std::bad_alloc.
void interpolate(const ProjectedDiagram& diagram, std::span<const double> values,
                 std::span<const double> lonLat, double weight, std::span<double> results);

}  // namespace apollonius::internal::sphere
