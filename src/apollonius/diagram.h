// The public C++ interface: the exact, fully dynamic additively weighted Voronoi diagram of
// circles.
//
// Distance of a point p to a site (c, r) is |p - c| - r: negative inside the circle. Every answer
// is exact for the doubles that were given: no answer depends on rounding, on the order of
// operations, or on the platform.
//
// Algorithm: Karavelas and Yvinec, "Dynamic Additively Weighted Voronoi Diagrams in 2D" (the paper
// below); predicates and the canonical rule for degenerate input: docs/PREDICATES.md. Units: those
// of the coordinates. "Counter-clockwise" is meant with y up; on a screen, where y points down, it
// looks clockwise. Of identical circles the one with the least id is visible, whatever the history.
// Costs: h = number of visible sites, d = number of neighbours of the site in question.
//
// Errors: no call throws, except the constructor (std::bad_alloc). A call that fails returns its
// Error and leaves the diagram as it was. Not thread-safe: one thread at a time, also for queries
// (they share scratch memory).
//
// Arithmetic must be IEEE 754's, rounded to nearest, with subnormals: a program that is linked with
// -ffast-math, for one, lacks them. The constructor checks this, and ends the program with a
// message if it does not hold.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <new>
#include <span>
#include <string>
#include <vector>

#include "apollonius/export.h"
#include "apollonius/types.h"

namespace apollonius {

enum class Error : std::uint8_t {
  kNone = 0,
  kNotFinite,        ///< a NaN or an infinity was given
  kOutOfRange,       ///< a magnitude above kLargestMagnitude (below kSmallestMagnitude: taken as 0)
  kUnknownSite,      ///< no site has this id
  kBadLength,        ///< lengths of arrays do not match, or are no multiple of the record's
  kOutOfMemory,      ///< memory ran out
  kTooLarge,         ///< more than kMostSites sites
  kBadBounds,        ///< a window that is empty, inverted, not finite or out of range
                     ///< (apollonius/voronoi.h)
  kCorruptSnapshot,  ///< the bytes are no snapshot, have an unknown version, or are damaged or
                     ///< forged; also returned by calls that find this out about trusted bytes
  kBadTarget,        ///< an area that no cell can have, or a cell that can have none
                     ///< (apollonius/area_fit.h)
  kNoConvergence,    ///< weights for given areas were not found (apollonius/area_fit.h)
  kBusy,             ///< the diagram has changed meanwhile (apollonius/area_fit.h)
  kBroken,           ///< a check that the library makes of its own result has failed: a defect of
                     ///< the library (Voronoi::cellPolygons)
};

/// A circle: centre and weight (radius). Negative weights are legal: only differences of weights
/// matter to the diagram.
struct Circle {
  double x;
  double y;
  double r;
};

/// The smallest circle around all circles, and the sites that touch it from inside, ascending. For
/// an empty diagram there are no sites, and the radius is -infinity.
struct EnclosingCircle {
  double x = 0;
  double y = 0;
  double r = -std::numeric_limits<double>::infinity();
  std::vector<SiteId> sites;
};

namespace internal {
class DiagramCore;
}

class APOLLONIUS_EXPORT Diagram {
 public:
  /// The one call that can throw: std::bad_alloc.
  explicit Diagram(Location location = Location::kHierarchy);
  ~Diagram();
  Diagram(Diagram&&) noexcept;
  Diagram& operator=(Diagram&&) noexcept;

  // --- Sites

  /// Adds a site. Duplicates and covered circles are legal (they become hidden sites).
  /// Errors: kNotFinite, kOutOfRange, kOutOfMemory, kTooLarge. Cost: location + O(size of the
  /// change).
  [[nodiscard]] Error insert(double x, double y, double r, SiteId& id);

  /// Adds xyr.size()/3 sites (x, y, r triples); ids[k] becomes the id of triple k. All or nothing.
  /// Errors: as insert; kBadLength unless xyr.size() == 3 * ids.size().
  [[nodiscard]] Error insertMany(std::span<const double> xyr, std::span<SiteId> ids);

  /// Adds triples from an array that is given up: it is freed as soon as they have been copied,
  /// before the large arrays are made, so that memory never holds both. Replaces the contents of
  /// `ids`. (After an error the array may have been freed or not.) Otherwise as above.
  [[nodiscard]] Error insertMany(std::vector<double>&& xyr, std::vector<SiteId>& ids);

  /// Removes a site; `removed` tells whether there was one. Sites that only it covered become
  /// visible again. Errors: kOutOfMemory. Cost: O(log n) amortised for a hidden site and for the
  /// visible one of nested or identical sites, else expected O(k log k) with k = d + the hidden
  /// sites directly below it.
  [[nodiscard]] Error remove(SiteId id, bool& removed);

  /// Removes several; unknown and repeated ids are skipped, `removed` counts the others. Errors:
  /// kOutOfMemory.
  [[nodiscard]] Error removeMany(std::span<const SiteId> ids, std::size_t& removed);

  /// Moves and/or resizes a site, which keeps its id. Errors: as insert, kUnknownSite.
  [[nodiscard]] Error update(SiteId id, double x, double y, double r);

  /// Updates ids[k] to triple k, all or nothing. Cost: as update for each; where many sites move
  /// far, that of building, with memory for two diagrams if there is some. Errors: as update;
  /// kBadLength unless xyr.size() == 3 * ids.size().
  [[nodiscard]] Error updateMany(std::span<const SiteId> ids, std::span<const double> xyr);

  /// Removes all sites; ids start from 0 again.
  void clear() noexcept;

  [[nodiscard]] std::size_t size() const noexcept;         ///< sites, hidden ones too
  [[nodiscard]] std::size_t visibleSize() const noexcept;  ///< sites with a cell
  [[nodiscard]] std::size_t hiddenSize()
      const noexcept;  ///< sites without one (the paper's trivial sites)
  [[nodiscard]] bool has(SiteId id) const noexcept;
  /// Number of ids that were ever used. All ids are below it.
  [[nodiscard]] std::size_t idLimit() const noexcept;
  [[nodiscard]] Error site(SiteId id, Circle& circle) const noexcept;  ///< Errors: kUnknownSite
  [[nodiscard]] Error ids(
      std::vector<SiteId>& ids) const;  ///< all ids, ascending; replaces the contents
  [[nodiscard]] Error sites(
      SiteArrays& sites) const;  ///< Replaces the contents. Errors: kOutOfMemory. Cost: O(n)
  [[nodiscard]] Error isHidden(SiteId id, bool& hidden) const noexcept;  ///< Errors: kUnknownSite

  /// A visible site that covers this one (the nearest one to its centre); kNoSite for a visible
  /// site. Errors: kUnknownSite, kOutOfMemory. Cost: one location.
  [[nodiscard]] Error coverOf(SiteId id, SiteId& cover) const;

  // --- Queries

  /// The nearest site of a point and its distance; ties go to the larger r, then x, then y. kNoSite
  /// and +infinity if empty. Exact choice; the distance is rounded. Errors: kNotFinite,
  /// kOutOfRange, kOutOfMemory.
  [[nodiscard]] Error find(double x, double y, SiteId& id) const;
  /// Also gives the distance |p - c| - r, with an error of less than one unit in the last place.
  [[nodiscard]] Error find(double x, double y, SiteId& id, double& distance) const;

  /// With a limit: kNoSite and infinity if the nearest site is farther than `maxDistance`
  /// (negative: that deep inside; infinity: no limit). The comparison is exact, and the limit
  /// itself is included. Errors: also kOutOfRange, kNotFinite of the limit.
  [[nodiscard]] Error find(double x, double y, double maxDistance, SiteId& id) const;
  [[nodiscard]] Error find(double x, double y, double maxDistance, SiteId& id,
                           double& distance) const;

  /// find for xy.size()/2 points. `distances` may be empty, else it has one element for each point.
  /// Errors: as find; kBadLength if the sizes do not match.
  [[nodiscard]] Error findMany(std::span<const double> xy, double maxDistance,
                               std::span<SiteId> ids, std::span<double> distances) const;
  [[nodiscard]] Error findMany(std::span<const double> xy, std::span<SiteId> ids,
                               std::span<double> distances) const {
    return findMany(xy, std::numeric_limits<double>::infinity(), ids, distances);
  }

  /// The k nearest sites of a point, hidden ones too, nearest first, of those at a distance of at
  /// most `maxDistance` (negative: that deep inside; infinity: all); ties as in find, identical
  /// circles ascending by id. If there are fewer than k, all of them. Exact, the limit included.
  /// Replaces the contents. Errors: as find. Cost: one location and O(m log m), m = the neighbours
  /// of the sites found.
  [[nodiscard]] Error kNearest(double x, double y, std::size_t k, double maxDistance,
                               std::vector<SiteId>& sites) const;
  [[nodiscard]] Error kNearest(double x, double y, std::size_t k,
                               std::vector<SiteId>& sites) const {
    return kNearest(x, y, k, std::numeric_limits<double>::infinity(), sites);
  }

  /// All sites at a distance of at most `distance`, in the order of kNearest; 0 gives the circles
  /// that contain the point. Errors and cost: as kNearest.
  [[nodiscard]] Error within(double x, double y, double distance,
                             std::vector<SiteId>& sites) const {
    return kNearest(x, y, size(), distance, sites);
  }

  /// kNearest for xy.size()/2 points, with distances as find gives them, or without. Errors: also
  /// kBadLength. Cost: less than single calls, as points are visited along a curve.
  [[nodiscard]] Error kNearestMany(std::span<const double> xy, std::size_t k, double maxDistance,
                                   bool withDistances, NearbyLists& lists) const;

  /// The circle under a pointer: of those that contain the point, rim included, the one on top;
  /// else the nearest site, if it is not farther than `maxDistance` (>= 0; infinity: wherever it
  /// is); else kNoSite. Exact. Errors: as find; kOutOfRange also if `maxDistance` is negative.
  /// Cost: as kNearest, for the circles that contain the point and one more.
  [[nodiscard]] Error pick(double x, double y, double maxDistance, Top top, SiteId& id) const;

  /// The circle whose far side is the farthest from a point, with the largest |p - c| + r, and that
  /// distance, with an error of less than one unit in the last place; ties go to the larger r, then
  /// x, then y. kNoSite and -infinity if empty. Exact choice. Errors: as find. Cost: O(length of
  /// the hull).
  [[nodiscard]] Error farthest(double x, double y, SiteId& id, double& distance) const;

  /// The smallest circle around all circles. Which sites touch it is decided exactly; centre and
  /// radius are rounded once, to the same bits after any history. Replaces the contents. Errors:
  /// kOutOfMemory. Cost: O(length of the hull) for each of a few circles.
  [[nodiscard]] Error enclosingCircle(EnclosingCircle& circle) const;

  /// All sites whose circles meet a rectangle, the rims and the border included, hidden ones too,
  /// ascending; the rectangle may be a segment or a point, and circles of negative radius meet
  /// none. Exact. Replaces the contents. Errors: kBadBounds (a number that is not finite or out of
  /// range, or min > max), kOutOfMemory. Cost: on sites spread evenly O(m log m), m = the sites
  /// found and those around the border.
  [[nodiscard]] Error search(double xmin, double ymin, double xmax, double ymax,
                             std::vector<SiteId>& sites) const;

  /// The distinct sites whose cells share an edge with this one's, counter-clockwise (each at its
  /// first occurrence), edges of length zero included (degenerate position; the graph is
  /// triangulated canonically); none for a hidden site. Replaces the contents. Errors:
  /// kUnknownSite, kOutOfMemory. Cost: O(d).
  [[nodiscard]] Error neighbors(SiteId id, std::vector<SiteId>& neighbors) const;

  /// The distinct sites from whose cells a new circle would take a part; if a site covers it, only
  /// that one, and `isCovered` is true. The diagram stays as it is. Replaces the contents. Errors:
  /// kNotFinite, kOutOfRange, kOutOfMemory. Cost: location, the degree of the nearest site, and the
  /// size of the change.
  [[nodiscard]] Error conflict(double x, double y, double r, std::vector<SiteId>& sites,
                               bool& isCovered) const;

  /// The Voronoi vertices. Each coordinate and clearance is within 2^-39 (|x| + |y| + |clearance|)
  /// + 2^-48 (the largest number among its three sites) of the exact one, whatever the sites, and
  /// the same bits after any history; of three sites whose coordinates and weights are multiples of
  /// one unit, no further apart than 2^17 of them, the coordinates are the nearest doubles.
  /// Replaces the contents. Errors: kOutOfMemory. Cost: O(h)
  [[nodiscard]] Error vertices(VertexArrays& vertices) const;
  [[nodiscard]] Error edges(
      EdgeArrays& edges) const;  ///< Replaces the contents. Errors: kOutOfMemory. Cost: O(h)
  /// The point of least clearance on each edge, and that clearance; row k belongs to edge k of
  /// edges(), and `sites` is empty. The point is on the segment between the two centres if the edge
  /// crosses it, else it is an end. Replaces the contents. Errors: kOutOfMemory. Cost: O(h)
  [[nodiscard]] Error narrowest(VertexArrays& places) const;

  /// The faces of the Delaunay graph, three sites each, counter-clockwise, kNoSite for infinity:
  /// the topology itself. Those without infinity are the rows of vertices(). A function of the
  /// sites and their ids, up to the order of the faces. Replaces the contents. Errors:
  /// kOutOfMemory. Cost: O(h)
  [[nodiscard]] Error faces(std::vector<SiteId>& sites) const;

  /// The sites that the convex hull of the circles touches, counter-clockwise; one can occur
  /// several times (a large circle with small ones sticking out; points in line, there and back).
  /// Replaces the contents. Errors: kOutOfMemory. Cost: O(length).
  [[nodiscard]] Error hull(std::vector<SiteId>& sites) const;

  /// Number of levels of the hierarchy that each site is on (paper, section 4), by id: a site with
  /// levels[id] = k is on levels 0, the diagram itself, to k - 1. 0 for a hidden site and for an id
  /// that is not in use; 1 for all visible sites with Location::kWalk. Replaces the contents.
  /// Errors: kOutOfMemory. Cost: O(n)
  [[nodiscard]] Error levels(std::vector<std::uint8_t>& levels) const;

  // --- Snapshots (docs/SNAPSHOTS.md)

  /// The diagram in bytes, the same on every platform; replaces the contents. Errors: kOutOfMemory.
  /// Cost: O(n), about 56 bytes a site.
  [[nodiscard]] Error toBytes(std::vector<std::uint8_t>& bytes) const;

  /// Becomes the diagram that was saved: sites, ids, free ids, hidden sites, graph; the location
  /// stays as it was chosen. The bytes are verified by exact arithmetic: even if they are forged,
  /// the diagram is that of the sites in them. Errors: kCorruptSnapshot, kOutOfMemory. Cost: O(n),
  /// without any search; on degenerate input (grids) about as long as building.
  ///
  /// Source::kTrusted skips the verification, for bytes that toBytes() wrote and nobody has
  /// changed, and is several times as fast; the Voronoi circles of faces are then computed when
  /// later calls first need them. With other bytes, answers may be wrong, and a call that finds out
  /// returns kCorruptSnapshot, as do all later calls with an Error except fromBytes(), until
  /// clear(); every call ends and stays within its memory.
  [[nodiscard]] Error fromBytes(std::span<const std::uint8_t> bytes,
                                Source source = Source::kAnyone);

  /// Checks every invariant with exact arithmetic and tells the first broken one. Errors:
  /// kOutOfMemory. Cost: O(n), slow: for tests.
  [[nodiscard]] Error validate(Violation& violation) const;
  /// In words; `broken` becomes empty if there is none.
  [[nodiscard]] Error validate(std::string& broken) const {
    Violation violation;
    const Error error = validate(violation);
    if (error != Error::kNone) return error;
    try {
      broken = violation.text();
    } catch (const std::bad_alloc&) {
      return Error::kOutOfMemory;
    }
    return Error::kNone;
  }

  /// Number of this state: it changes with every change, and no other state of any diagram of the
  /// process has the same.
  [[nodiscard]] std::uint64_t revision() const noexcept { return state_; }

 private:
  friend class AreaFit;  // apollonius/area_fit.h
  friend class Voronoi;  // its geometry: apollonius/voronoi.h
  template <class AnyDiagram>
  friend class BuilderOf;  // in steps: apollonius/builder.h
  template <class AnyDiagram>
  friend class NearestFirstOf;  // the sites around a point, one by one: apollonius/nearest_first.h

  /// To be called before anything changes.
  void change() noexcept;

  std::unique_ptr<internal::DiagramCore> core_;
  std::uint64_t state_ = 0;  // revision()
};

}  // namespace apollonius
