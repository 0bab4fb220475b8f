// The additively weighted Voronoi diagram on the sphere, fully dynamic: for maps.
//
// A site is a centre in degrees of longitude and latitude, and a weight r in the unit of the
// sphere's radius. The distance of a point to it is the way along a great circle minus r. A
// positive weight is the radius of a cap, or a head start; only differences of weights matter.
//
// The diagram is computed as one of the plane, which is exact, after a stereographic projection
// from one of the sites (docs/PROOFS.md, "The sphere"). Directions and projected circles are
// rounded to doubles. So the graph is the exact one of sites that are within some 10^-15 radians of
// the given ones (6 nanometres on the Earth), or up to 10^-13 beside a site that nearly hides
// another. In degenerate position, rounding decides which edges without length it has.
//
// Errors, costs and threads: as apollonius/diagram.h.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "apollonius/diagram.h"
#include "apollonius/export.h"
#include "apollonius/types.h"
#include "apollonius/voronoi.h"

namespace apollonius {

/// Centre in degrees and weight in the unit of the sphere's radius.
struct SphericalCircle {
  double lon;
  double lat;
  double r;
};

/// The distance for cells without a limit, which end only at other cells.
inline constexpr double kEverywhere = std::numeric_limits<double>::infinity();

/// The finest tolerance of polygons, in radians.
inline constexpr double kFinestTolerance = 1e-9;

/// A point in degrees.
struct SphericalPoint {
  double lon;
  double lat;
};

namespace internal::sphere {
class SphericalCore;
}

/// Calls that Diagram has, too, are documented there; the comments here name the differences.
class APOLLONIUS_EXPORT SphericalDiagram {
 public:
  /// A diagram on a sphere of this radius, whose unit is that of weights and distances (and,
  /// squared, of areas): 1 gives radians, 6371.0088 kilometres on the Earth. Throws std::bad_alloc.
  /// REQUIRES: isRadius(radius).
  explicit SphericalDiagram(double radius = 1);
  ~SphericalDiagram();
  SphericalDiagram(SphericalDiagram&&) noexcept;
  SphericalDiagram& operator=(SphericalDiagram&&) noexcept;

  /// Can a sphere have this radius: is it in the range of weights, and above 0?
  [[nodiscard]] static bool isRadius(double radius) noexcept;
  [[nodiscard]] double radius() const noexcept;

  // --- Sites

  /// Adds a site; any longitude. Errors: kNotFinite, kOutOfRange (a latitude outside [-90, 90], a
  /// weight of half a great circle or more), kOutOfMemory, kTooLarge. Cost: as in the plane; when
  /// the number of sites has doubled, and when the new site hides the one that the diagram is
  /// projected from (one in h), that of building.
  [[nodiscard]] Error insert(double lon, double lat, double r, SiteId& id);

  /// Adds lon, lat, r triples.
  [[nodiscard]] Error insertMany(std::span<const double> sites, std::span<SiteId> ids);

  /// Cost: for one in h sites, that of building.
  [[nodiscard]] Error remove(SiteId id, bool& removed);
  [[nodiscard]] Error removeMany(std::span<const SiteId> ids, std::size_t& removed);

  /// Cost: for one in h sites, and for many at once, that of building.
  [[nodiscard]] Error update(SiteId id, double lon, double lat, double r);
  [[nodiscard]] Error updateMany(std::span<const SiteId> ids, std::span<const double> sites);

  void clear() noexcept;

  [[nodiscard]] std::size_t size() const noexcept;
  [[nodiscard]] std::size_t visibleSize() const noexcept;
  [[nodiscard]] bool has(SiteId id) const noexcept;
  [[nodiscard]] std::size_t idLimit() const noexcept;
  [[nodiscard]] Error site(SiteId id, SphericalCircle& circle) const noexcept;
  [[nodiscard]] Error ids(std::vector<SiteId>& ids) const;
  /// `xyr` has lon, lat, r.
  [[nodiscard]] Error sites(SiteArrays& sites) const;
  [[nodiscard]] Error isHidden(SiteId id, bool& hidden) const noexcept;
  [[nodiscard]] Error coverOf(SiteId id, SiteId& cover) const;

  // --- Queries. Errors: kNotFinite, kOutOfRange (a latitude), kOutOfMemory

  /// The nearest site, to within 4 units of 2^-53 radians; any one of equally near ones. Distances
  /// are rounded, also when they are compared with `maxDistance`. Cost: one location.
  [[nodiscard]] Error find(double lon, double lat, SiteId& id) const;
  [[nodiscard]] Error find(double lon, double lat, SiteId& id, double& distance) const;
  [[nodiscard]] Error find(double lon, double lat, double maxDistance, SiteId& id) const;
  [[nodiscard]] Error find(double lon, double lat, double maxDistance, SiteId& id,
                           double& distance) const;
  /// The site whose far side is the farthest from a point: the nearest one to the opposite point.
  /// kNoSite and -infinity if empty.
  [[nodiscard]] Error farthest(double lon, double lat, SiteId& id, double& distance) const;
  [[nodiscard]] Error findMany(std::span<const double> lonLat, double maxDistance,
                               std::span<SiteId> ids, std::span<double> distances) const;
  [[nodiscard]] Error findMany(std::span<const double> lonLat, std::span<SiteId> ids,
                               std::span<double> distances) const {
    return findMany(lonLat, std::numeric_limits<double>::infinity(), ids, distances);
  }
  /// In the order of rounded distances.
  [[nodiscard]] Error kNearest(double lon, double lat, std::size_t k, double maxDistance,
                               std::vector<SiteId>& sites) const;
  [[nodiscard]] Error kNearestMany(std::span<const double> lonLat, std::size_t k,
                                   double maxDistance, bool withDistances,
                                   NearbyLists& lists) const;
  /// A site contains the points at a (rounded) distance of at most 0.
  [[nodiscard]] Error pick(double lon, double lat, double maxDistance, Top top, SiteId& id) const;
  [[nodiscard]] Error neighbors(SiteId id, std::vector<SiteId>& neighbors) const;
  /// `coordinates` has longitude and latitude.
  [[nodiscard]] Error vertices(VertexArrays& vertices) const;
  /// The `most` largest circles that no site reaches into, the largest first, none with its centre
  /// in one before it. Each row has longitude and latitude, the distance to the nearest site (below
  /// 0 if the whole sphere is covered), and one site, the nearest. Replaces the contents. Errors:
  /// kOutOfMemory. Cost: O(h (log n + most))
  [[nodiscard]] Error emptyCircles(std::size_t most, VertexArrays& circles) const;
  /// Both ends of the closed edge of two sites are -1.
  [[nodiscard]] Error edges(EdgeArrays& edges) const;
  [[nodiscard]] Error narrowest(VertexArrays& places) const;

  // --- Cells. Errors: kUnknownSite, kOutOfMemory
  //
  // `distance` limits a cell: it ends this far beyond the circle of its site, in the unit of the
  // radius; with kEverywhere it ends only at other cells. `distances` has one for each id that was
  // ever used, or one for all cells, or none for kEverywhere. Errors: also kNotFinite, kOutOfRange;
  // kBadLength.

  /// The sites on the other side of a cell's edges, counter-clockwise, one row for each edge, and
  /// the least distance of the edge from both circles: cells with a larger limit share a part of
  /// the edge. None for a hidden site. Replaces the contents. Cost: O(d)
  [[nodiscard]] Error cellNeighbors(SiteId id, std::vector<SiteId>& neighbors,
                                    std::vector<double>& distances) const;
  /// Is the point in the closed cell? False for a hidden site. Errors: also as find.
  [[nodiscard]] Error contains(SiteId id, double lon, double lat, double distance,
                               bool& inside) const;
  /// Area of a cell, in the squared unit of the radius; 0 for a hidden site. Cost: O(d)
  [[nodiscard]] Error cellArea(SiteId id, double distance, double& area) const;
  /// Length of a cell's boundary, in the unit of the radius; 0 for a hidden site. Cost: O(d)
  [[nodiscard]] Error cellPerimeter(SiteId id, double distance, double& perimeter) const;
  /// Areas of all cells by id, 0 for hidden sites and ids that are not in use. They add up to 4 pi
  /// radius², with distances to at most that, which is checked to 10^-5 of it. Replaces the
  /// contents. Errors: also kBroken, a defect of the library. Cost: O(h)
  [[nodiscard]] Error cellAreas(std::span<const double> distances,
                                std::vector<double>& areas) const;
  /// Perimeters of all cells by id, 0 as for areas. Replaces the contents. Cost: O(h)
  [[nodiscard]] Error cellPerimeters(std::span<const double> distances,
                                     std::vector<double>& perimeters) const;
  /// The direction of the mean, in space, of the cell's points; the site's centre if the mean is 0.
  /// NaN for a hidden site and for a cell that ends at its centre or before. Cost: O(d)
  [[nodiscard]] Error cellCentroid(SiteId id, double distance, SphericalPoint& centroid) const;
  /// The largest circle inside a cell: r, in the radius' unit, is at least 0.999 of the largest
  /// possible, and the circle is inside up to rounding; for the whole sphere, r is half a great
  /// circle. NaN for a hidden site and for a cell that does not reach beyond its centre. Errors:
  /// also kNoConvergence for a cell that is thousands of times as long as wide. Cost: some hundred
  /// times O(d)
  [[nodiscard]] Error cellCircle(SiteId id, double distance, SphericalCircle& circle) const;
  /// A cell as closed rings of longitude and latitude, counter-clockwise as seen from outside of
  /// the sphere; none for a hidden site. Unless `isCut`, points are joined by arcs of great
  /// circles, and a cell is one ring, or none if it is the whole sphere. With `isCut`, it is one
  /// part or more of the rectangle [-180, 180] x [-90, 90], in which points are joined by straight
  /// lines. `tolerance` is in radians, at least kFinestTolerance. Replaces the contents. Errors:
  /// also kNotFinite, kOutOfRange (the tolerance). Cost: O(d + points)
  [[nodiscard]] Error cellPolygon(SiteId id, double tolerance, bool isCut, double distance,
                                  RingArrays& rings) const;
  /// The polygons of all cells that are not empty. Neighbours have the points of their common edges
  /// in common. Replaces the contents. Errors: also kBroken, a defect of the library: with `isCut`
  /// and without distances, they do not fill the rectangle. Cost: O(h + points)
  [[nodiscard]] Error cellPolygons(double tolerance, bool isCut, std::span<const double> distances,
                                   CoverageArrays& polygons) const;

  // --- Natural neighbours (Sibson). Errors: as insert for the numbers of a site, kOutOfMemory

  /// The sites from whose cells a new site would take a part, and each part's share of the new
  /// cell. A site that covers it is the only one; none without sites. The diagram stays as it is.
  /// Cost: one location, and O(size of the change).
  [[nodiscard]] Error naturalWeights(double lon, double lat, double r, NaturalWeights& found) const;
  /// Values of a field at points longitude, latitude, …: sums of `values`, given by id, times the
  /// naturalWeights() of a site of weight r there. NaN without sites. Fills `results`, one for each
  /// point. Errors: also kBadLength unless there is a value for each id that was ever used and a
  /// result for each point. Cost: as naturalWeights(); points are visited along a curve.
  [[nodiscard]] Error interpolate(std::span<const double> values, std::span<const double> lonLat,
                                  double r, std::span<double> results) const;

  // --- Snapshots

  /// The diagram in bytes: sites, ids and hidden sites. The restored diagram gives the same
  /// answers, and the same ids to new sites. Replaces the contents. Errors: kOutOfMemory. Cost:
  /// O(n), 28 bytes for each site and 8 more for a hidden one.
  [[nodiscard]] Error toBytes(std::vector<std::uint8_t>& bytes) const;
  /// Becomes the diagram that was saved, with its radius. Even if the bytes are forged, the diagram
  /// is that of the sites in them. Errors: kCorruptSnapshot, kOutOfMemory. Cost: that of building.
  [[nodiscard]] Error fromBytes(std::span<const std::uint8_t> bytes);

  /// Number of this state: another one after each change, as long as the diagram lives.
  [[nodiscard]] std::uint64_t revision() const noexcept;

  /// Checks every invariant and tells the first broken one. Errors: kOutOfMemory. Cost: O(n), slow:
  /// for tests.
  [[nodiscard]] Error validate(Violation& violation) const;

 private:
  template <class AnyDiagram>
  friend class BuilderOf;
  template <class AnyDiagram>
  friend class NearestFirstOf;

  [[nodiscard]] Error distancesError(std::span<const double> distances) const;
  [[nodiscard]] Error cellError(SiteId id, double distance) const;
  void become(std::unique_ptr<internal::sphere::SphericalCore> restored) noexcept;

  std::unique_ptr<internal::sphere::SphericalCore> core_;
};

}  // namespace apollonius
