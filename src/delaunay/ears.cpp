#include "delaunay/ears.h"

#include "predicate/compute_circle.h"
#include "predicate/predicates.h"
#include "predicate/stage_counts.h"

namespace apollonius::internal {

bool EarClipper::fill(const DelaunayGraph& delaunay, VertexId v, std::span<const HalfedgeId> link) {
  const Graph& graph = delaunay.graph();
  corners_.clear();
  patch_.clear();
  circles_.clear();
  if (link.size() > kMostCorners) return false;
  for (std::uint32_t k = 0; k < link.size(); ++k) {
    const VertexId vertex = graph.origin(link[k]);
    for (const CornerOfHole& other : corners_) {
      if (other.vertex == vertex) return false;
    }
    corners_.push_back({vertex, Graph::kOutside | k});
  }

  const Site& removed = delaunay.site(v);
  std::size_t b = 1, failures = 0;  // b: the middle corner of the ear that is tried
  VoronoiCircle circle;
  while (corners_.size() > 3) {
    const std::size_t n = corners_.size(), a = b > 0 ? b - 1 : n - 1, c = b + 1 < n ? b + 1 : 0;
    if (!isEar(delaunay, removed, a, b, c, circle)) {
      if (++failures == n) return false;
      b = c;
      continue;
    }
    addFace(a, b, c, circle);
    corners_[a].side =
        3 * static_cast<std::uint32_t>(patch_.size() - 1) + 2;  // the chord c → a of the new face
    corners_.erase(b);
    failures = 0;
    // Next the end of the chord: its ear has a new side.
    b = b < corners_.size() ? b : 0;
  }
  if (!findVoronoiCircle(delaunay.corner(corners_[0].vertex), delaunay.corner(corners_[1].vertex),
                         delaunay.corner(corners_[2].vertex), circle)) {
    return false;
  }
  addFace(0, 1, 2, circle);
  join(3 * static_cast<std::uint32_t>(patch_.size() - 1) + 2, corners_[2].side);
  return true;
}

bool EarClipper::isEar(const DelaunayGraph& delaunay, const Site& removed, std::size_t a,
                       std::size_t b, std::size_t c, VoronoiCircle& circle) const {
  const Corner i = delaunay.corner(corners_[a].vertex), j = delaunay.corner(corners_[b].vertex),
               k = delaunay.corner(corners_[c].vertex);
  if (!findVoronoiCircle(i, j, k, circle)) return false;
  const auto isInConflict = [&](const Site& site) {
    const MaybeSign filtered = circleFilter(circle, site);
    stages::counts().vertexAtOnce += filtered.known;
    return filtered.known && !kShadowCheck ? filtered.sign == Sign::kPositive
                                           : isVertexInConflict(circle, i, j, k, site);
  };
  if (!isInConflict(removed)) return false;
  // The corners behind the ear are the likely ones.
  const std::size_t n = corners_.size();
  for (std::size_t step = 1; step + 2 < n; ++step) {
    const std::size_t other = c + step < n ? c + step : c + step - n;
    const Corner corner = delaunay.corner(corners_[other].vertex);
    if (corner != nullptr ? isInConflict(*corner) : false) return false;
  }
  return true;
}

/// Adds the face of three consecutive corners and joins its first two sides.
void EarClipper::addFace(std::size_t a, std::size_t b, std::size_t c, const VoronoiCircle& circle) {
  const std::uint32_t first = 3 * static_cast<std::uint32_t>(patch_.size());
  patch_.push_back({{corners_[a].vertex, corners_[b].vertex, corners_[c].vertex}, {0, 0, 0}});
  circles_.push_back(circle);
  join(first, corners_[a].side);
  join(first + 1, corners_[b].side);
}

/// Makes a half-edge of the patch and `side`, a half-edge of the patch or of the link, neighbours.
void EarClipper::join(std::uint32_t halfedge, std::uint32_t side) {
  patch_[halfedge / 3].across[halfedge % 3] = side;
  if ((side & Graph::kOutside) == 0) patch_[side / 3].across[side % 3] = halfedge;
}

}  // namespace apollonius::internal
