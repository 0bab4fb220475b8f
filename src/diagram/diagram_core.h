// The dynamic diagram: the Delaunay graph of the visible sites, the forest of the hidden ones, the hierarchy and the grid
// for location, and the ids that hold them together. Arguments have been checked by the caller (apollonius.cpp); lack of memory is thrown as
// std::bad_alloc with the diagram as it was before the call.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "diagram/ballast.h"
#include "diagram/delaunay_graph.h"
#include "diagram/hidden.h"
#include "diagram/hierarchy.h"
#include "diagram/remove.h"
#include "diagram/site_ids.h"
#include "diagram/start_grid.h"
#include "diagram/vocabulary.h"

namespace apollonius {

class DiagramCore {
 public:
  explicit DiagramCore(Location location)
      : usesHierarchy_(location != Location::kWalk),
        walk_(location == Location::kHierarchy ? Walk::kSectors : Walk::kAllNeighbors),
        hierarchy_(walk_) {}

  SiteId insert(const Site& site);
  void insertMany(std::span<const double> xyr, std::span<SiteId> ids);
  bool remove(SiteId id);
  /// How many of the ids were in use.
  std::size_t removeMany(std::span<const SiteId> ids);
  void update(SiteId id, const Site& site);
  void updateMany(std::span<const SiteId> ids, std::span<const double> xyr);
  void clear() noexcept;

  [[nodiscard]] const SiteIds& ids() const { return ids_; }
  [[nodiscard]] std::size_t visibleCount() const { return base_.visibleCount(); }
  [[nodiscard]] const Site& site(SiteId id) const { return base_.site(vertexOf(id)); }
  [[nodiscard]] const DelaunayGraph& base() const { return base_; }

  /// The nearest site; `hint` is a site close to the point, or kNoSite. REQUIRES: not empty.
  [[nodiscard]] SiteId nearest(double x, double y, SiteId hint = kNoSite) const;

  /// Sites in the order of their distance to (x, y), at most `most`, and none farther than `farthest` if that is given; ties as in
  /// nearest(). Replaces the contents of `sites`.
  void nearby(double x, double y, std::size_t most, const double* farthest, std::vector<SiteId>& sites) const;

  // Listings; each replaces the contents of its argument.
  void neighbors(SiteId id, std::vector<SiteId>& neighbors) const;
  void vertices(VertexArrays& vertices) const;
  void edges(EdgeArrays& edges) const;
  void faces(std::vector<SiteId>& sites) const;

  /// Empty, or the first broken invariant.
  [[nodiscard]] std::string check() const;

  [[nodiscard]] static VertexId vertexOf(SiteId id) { return VertexId{id + 1}; }
  [[nodiscard]] static SiteId siteOf(VertexId v) { return static_cast<SiteId>(v) - 1; }

 private:
  friend class DiagramBreaker;  // tests break a structure on purpose

  /// Room for everything that is kept per site.
  void reserve(std::size_t sites);
  SiteId insertNear(const Site& site, VertexId start);
  /// Places a site whose id is in no structure; `start` is visible, or kNoVertex to locate from scratch. May throw; else the
  /// returned state is what the id is to get.
  [[nodiscard]] SiteState place(SiteId id, const Site& site, VertexId start);
  /// Takes a site out of all structures; its id becomes pending.
  void displace(SiteId id);
  /// Displaces a site and places it elsewhere; a site that cannot be placed returns to where it was.
  void move(SiteId id, const Site& site);
  /// Undoes a displacement. There is room for it: the ballast has been dropped.
  void restore(SiteId id, const Site& site) noexcept { ids_.setState(id, place(id, site, kNoVertex)); }
  void displaceVisible(SiteId id);
  /// What location needs to know of a site that became visible, and of one that is visible no more.
  void enterLocation(SiteId id) noexcept;
  void leaveLocation(SiteId id) noexcept;
  void rebuildGrid() noexcept;
  [[nodiscard]] VertexId startFor(double x, double y) const;

  [[nodiscard]] bool hasFiniteVertex(FaceId f) const;
  [[nodiscard]] bool isEdgeAtInfinity(HalfedgeId h, const std::vector<std::int32_t>& finite) const;
  [[nodiscard]] std::string checkHidden() const;

  bool usesHierarchy_;
  Walk walk_;
  SiteIds ids_;
  DelaunayGraph base_;        // vertex of site id: id + 1
  HiddenForest hidden_;       // node of site id: id
  Hierarchy hierarchy_;
  StartGrid grid_;            // with Walk::kSectors only
  Remover remover_;
  Ballast ballast_;
  std::vector<VertexId> children_;  // scratch of displaceVisible
};

}  // namespace apollonius
