// Types that the public interface and the diagram share: ids, ways of location, arrays of results.
// Plain standard types; users get them with apollonius/diagram.h.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace apollonius {

/// A site's public name: stable while the site lives; ids of removed sites are used again.
using SiteId = std::uint32_t;
inline constexpr SiteId kNoSite = 0xFFFFFFFFu;
/// In place of the number of a group: the site is in none.
inline constexpr std::uint32_t kNoGroup = 0xFFFFFFFFu;

/// Most sites that one diagram can hold.
inline constexpr std::size_t kMostSites = std::size_t{1} << 29;

/// Numbers of a smaller magnitude are taken as 0, those of a larger one are errors.
inline constexpr double kSmallestMagnitude = 1e-100;
inline constexpr double kLargestMagnitude = 1e100;
/// The number that is used for one given to a call. Also turns -0 into 0.
constexpr double taken(double value) {
  return -kSmallestMagnitude < value && value < kSmallestMagnitude ? 0.0 : value;
}
/// May a coordinate or a weight have this value once it has been taken? False for NaN and
/// infinities.
constexpr bool isInRange(double value) {
  const double magnitude = value < 0 ? -value : value;
  return magnitude == 0 || (magnitude >= kSmallestMagnitude && magnitude <= kLargestMagnitude);
}

/// The first broken invariant that a check found; one without `what` found none.
struct Violation {
  const char* what = nullptr;  ///< ends with the kind of thing that `where` names
  std::uint32_t where = 0;     ///< an index, id or count
  std::uint32_t level = 0;     ///< level of the hierarchy (0 is the diagram itself)

  [[nodiscard]] bool isFound() const { return what != nullptr; }
  /// The violation in words; empty if there is none. Throws std::bad_alloc.
  [[nodiscard]] std::string text() const {
    if (what == nullptr) return {};
    const std::string found = what + (' ' + std::to_string(where));
    return level == 0 ? found : "level " + std::to_string(level) + ": " + found;
  }
};

/// Who made the bytes of a snapshot. kAnyone: they are verified to be the diagram of their sites.
/// kTrusted: they are not.
enum class Source : std::uint8_t { kAnyone, kTrusted };

/// How the nearest site is located (paper, section 4). The answers are the same.
enum class Location : std::uint8_t {
  kWalk,  ///< the paper's plain walk: all neighbours of a site are asked; O(h) at worst, about
          ///< sqrt(h) on random input
  kPlainHierarchy,  ///< the paper's hierarchy of Delaunay graphs, with that walk on each level
  kHierarchy,       ///< the hierarchy, with a walk that asks one neighbour of a site: about log h,
                    ///< whatever the degrees
};

/// Which of several circles that contain a point is on top: the one with the smallest radius (of
/// equal ones the nearest, as find has it), as where large circles are drawn first; or the last,
/// with the largest id, as where all are drawn in the order of their ids.
enum class Top : std::uint8_t { kSmallest, kLast };

/// All sites, hidden ones too; row k of each array belongs to the k-th of them, ascending by id.
struct SiteArrays {
  std::vector<SiteId> ids;
  std::vector<double> xyr;           ///< x, y, r of each site, as they were taken
  std::vector<std::uint8_t> hidden;  ///< 1 for a site without a cell, else 0
};

/// The sites near each of several points, as the rows of a sparse matrix: those of point k are
/// ids[starts[k]] to ids[starts[k + 1] - 1], nearest first.
struct NearbyLists {
  std::vector<SiteId> ids;
  std::vector<std::uint32_t> starts;  ///< one more than there are points
  std::vector<double> distances;      ///< one a site of `ids`, or none at all
};

/// The Voronoi vertices; row k of each array belongs to vertex k. The rows' order
/// depends on the history.
struct VertexArrays {
  std::vector<double> coordinates;   ///< x, y of each vertex
  std::vector<double> clearance;     ///< common distance to its three sites
  std::vector<std::uint32_t> sites;  ///< the three sites, counter-clockwise around the vertex's
                                     ///< circle; of a view's vertex of two the third one is kNoSite
};

/// The Voronoi edges. Two sites can share several. Where more than three sites touch one circle,
/// the canonical rule makes edges of length zero, and several vertices at one place.
struct EdgeArrays {
  std::vector<std::uint32_t> sites;  ///< two sites a, b of each edge
  std::vector<std::int32_t>
      vertices;  ///< its two ends as rows of VertexArrays, -1 for an unbounded end; walking from
                 ///< the first to the second keeps a's cell on the left
};

}  // namespace apollonius
