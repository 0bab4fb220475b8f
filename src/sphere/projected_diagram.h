// The sites of the sphere as circles of the plane, projected from one visible site, the pole, and
// the plane's diagram of these (projection.h).
//
// Nodes are the plane's vertices, and its vertex at infinity is the pole. A site has the same id in
// the plane. Sites that the pole covers have no circle and are listed separately.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "apollonius/types.h"
#include "base/flat_array.h"
#include "diagram/bulk_insertion.h"
#include "diagram/diagram_core.h"
#include "sphere/direction_grid.h"
#include "sphere/projection.h"
#include "sphere/site_table.h"

namespace apollonius::internal::sphere {

/// A hidden site, and a site that covers it, which may be hidden, too.
struct HiddenSite {
  SiteId site = kNoSite;
  SiteId cover = kNoSite;
};

class ProjectedDiagram {
 public:
  class Filling;

  /// Without sites.
  ProjectedDiagram() : plane_(Location::kHierarchy, Naming::kGiven) {}
  /// Projected from `pole`, still without other sites, which Filling enters.
  ProjectedDiagram(const Cap& poleCap, SiteId pole)
      : pole_(pole),
        poleCap_(poleCap),
        projection_(poleCap),
        plane_(Location::kHierarchy, Naming::kGiven) {}

  /// Enters hidden sites, as listed by hidden(); `caps` are those of all sites by id. If their
  /// covers do not cover them, returns false, and the diagram is unusable. Throws std::bad_alloc.
  /// REQUIRES: all visible sites have been entered; each hidden site is listed once.
  [[nodiscard]] bool enterHidden(const FlatArray<Cap>& caps, std::span<const HiddenSite> hidden);

  // --- Reading. Sites are those of the table, nodes are vertices of the plane's graph.

  [[nodiscard]] bool isEmpty() const { return pole_ == kNoSite; }
  [[nodiscard]] SiteId pole() const { return pole_; }
  [[nodiscard]] const DiagramCore& plane() const { return plane_; }
  [[nodiscard]] const Graph& graph() const { return plane_.delaunay().graph(); }
  [[nodiscard]] const Projection& projection() const { return projection_; }
  [[nodiscard]] std::size_t visibleCount() const {
    return isEmpty() ? 0 : plane_.visibleCount() + 1;
  }
  /// The largest loss of a circle's accuracy (Projection::Image).
  [[nodiscard]] double loss() const { return loss_; }
  /// Have circles lost so much accuracy that another pole should be chosen?
  [[nodiscard]] bool isRough() const { return loss_ > kMostLoss; }

  [[nodiscard]] const Cap& cap(VertexId node) const {
    return node == kInfinity ? poleCap_ : caps_[slotOf(node)];
  }
  /// cos d - cos D of two nodes (Projection::rise).
  [[nodiscard]] double rise(VertexId a, VertexId b) const {
    const DelaunayGraph& delaunay = plane_.delaunay();
    if (a == kInfinity) return Projection::riseFromPole(delaunay.site(b));
    if (b == kInfinity) return Projection::riseFromPole(delaunay.site(a));
    return Projection::rise(delaunay.site(a), delaunay.site(b));
  }
  /// The sine of the first one's weight minus the other's, equally accurate.
  [[nodiscard]] double shift(VertexId a, VertexId b) const {
    const DelaunayGraph& delaunay = plane_.delaunay();
    if (a == kInfinity) return Projection::shiftFromPole(delaunay.site(b));
    if (b == kInfinity) return -Projection::shiftFromPole(delaunay.site(a));
    return Projection::shift(delaunay.site(a), delaunay.site(b));
  }
  /// Are two nodes so close that their circles are more accurate than their caps? The graph was
  /// made of the circles, whose rounding differs from that of the caps.
  [[nodiscard]] bool areClose(VertexId a, VertexId b) const {
    const Direction chord = cap(b).centre - cap(a).centre;
    return dot(chord, chord) < kClose * kClose;
  }
  /// A vector in the direction from the first of two close nodes to the second, in the plane of
  /// their centres.
  [[nodiscard]] Direction towards(VertexId from, VertexId to) const {
    const Direction chord = cap(to).centre - cap(from).centre;
    if (from == kInfinity || to == kInfinity) return chord;
    // At the distance p from the pole, the direction between circles at the distance D is accurate
    // to 2^-53 / p, and the direction between their caps to 2^-53 p / D.
    const Direction away = cap(from).centre - poleCap_.centre;
    const double square = dot(away, away);
    if (dot(chord, chord) > square * square) return chord;
    const DelaunayGraph& delaunay = plane_.delaunay();
    return projection_.towards(delaunay.site(from), delaunay.site(to));
  }
  [[nodiscard]] SiteId siteOf(VertexId node) const {
    return node == kInfinity ? pole_ : plane_.siteOf(node);
  }
  /// The node of a site; kNoVertex if the pole covers it.
  [[nodiscard]] VertexId nodeOf(SiteId id) const {
    if (id == pole_) return kInfinity;
    return isBelowPole(id) ? kNoVertex : vertexOf(plane_.ids().slotOf(id));
  }
  [[nodiscard]] bool isHidden(SiteId id) const {
    return isBelowPole(id) ||
           (id != pole_ && plane_.ids().state(slotOf(nodeOf(id))) == SiteState::kHidden);
  }
  /// The sites that the pole covers.
  [[nodiscard]] std::span<const SiteId> belowPole() const {
    return {belowPole_.data(), belowPole_.size()};
  }

  /// All hidden sites. A hidden cover comes before the sites that hang on it. Throws
  /// std::bad_alloc.
  [[nodiscard]] FlatArray<HiddenSite> hidden(const SiteTable& sites) const;

  /// A visible node that is probably close to a point; kNoVertex if none is known.
  [[nodiscard]] VertexId hintFor(const Direction& point) const {
    const Slot slot = grid_.at(point);
    return plane_.ids().state(slot) == SiteState::kVisible ? vertexOf(slot) : kNoVertex;
  }

  /// The number of a direction's cell. Close directions have mostly close numbers.
  [[nodiscard]] std::uint32_t cellOf(const Direction& point) const { return grid_.cellOf(point); }

  // --- Changing. If a call returns false, it has changed nothing, and all sites have to be
  // projected from another pole: because the pole is affected or gets hidden, or a circle would
  // lose too much accuracy. All throw std::bad_alloc and have changed nothing then.

  /// Inserts sites that have come into the table.
  [[nodiscard]] bool insert(const SiteTable& sites, std::span<const SiteId> ids);
  /// Removes sites that are about to leave the table, each once.
  [[nodiscard]] bool remove(std::span<const SiteId> ids);
  /// Updates sites that have moved in the table. The last of several entries of one site counts, as
  /// there.
  [[nodiscard]] bool update(const SiteTable& sites, std::span<const SiteId> ids);

  /// A broken invariant of the data kept in addition to the plane's diagram, or nullptr; `where`
  /// receives a site.
  [[nodiscard]] const char* check(const SiteTable& sites, std::uint32_t& where) const;

 private:
  static constexpr double kMostLoss = 16 * kUsualLoss;

  /// REQUIRES: a site of the diagram.
  [[nodiscard]] bool isBelowPole(SiteId id) const {
    return id != pole_ && plane_.ids().slotOf(id) == kNoSlot;
  }
  /// Enters a hidden site of a snapshot. False if its cover does not cover it, as computed.
  [[nodiscard]] bool enterBelow(const HiddenSite& hidden, const Cap& cap);
  [[nodiscard]] bool isTooRough(double loss) const;
  void reserve(std::size_t idLimit, std::size_t circles);
  void setCap(SiteId id, const Cap& cap) {
    const Slot slot = plane_.ids().slotOf(id);
    caps_[slot] = cap;
    if (plane_.ids().state(slot) == SiteState::kVisible) grid_.set(cap.centre, slot);
  }
  /// Enters a site that the pole covers. A site that is identical to the pole becomes the pole
  /// itself if its id is less, and the former pole is below it. REQUIRES: room.
  void enterBelowPole(SiteId id, const Cap& cap) noexcept;
  void leaveBelowPole(SiteId id) noexcept;
  // The changes for one site, without arrays.
  [[nodiscard]] bool insertOne(const SiteTable& sites, SiteId id);
  [[nodiscard]] bool removeOne(SiteId id);
  [[nodiscard]] bool updateOne(const SiteTable& sites, SiteId id);

  SiteId pole_ = kNoSite;
  Cap poleCap_;
  Projection projection_;
  DiagramCore plane_;
  FlatArray<Cap> caps_;  // by slot of the plane
  FlatArray<SiteId> belowPole_;
  FlatArray<std::uint32_t>
      placeBelowPole_;  // by site that the pole covers: its index in belowPole_
  DirectionGrid grid_;
  double loss_ = 1;
};

/// Enters all sites of a diagram that has only its pole, in steps.
class ProjectedDiagram::Filling {
 public:
  /// Enters the sites of the table with these ids: all visible ones, and any of the hidden ones.
  /// `caps` are those of all sites by id. The diagram, the table and the caps must stay where they
  /// are, and the diagram is unusable until all is done. Throws std::bad_alloc. REQUIRES: the pole
  /// is visible and not among the ids.
  Filling(ProjectedDiagram& diagram, const SiteTable& sites, const FlatArray<Cap>& caps,
          FlatArray<SiteId> ids);

  /// Goes on by about `steps`, of about a microsecond each. True if all is done. Throws
  /// std::bad_alloc, and has to be given up then. Total cost: that of building a diagram of the
  /// plane.
  bool advance(std::size_t steps);

  /// The share of the work that is done, 0 to 1, by estimated time.
  [[nodiscard]] double progress() const;

 private:
  enum class Step : std::uint8_t { kProject, kStage, kInsert, kEnter, kDone };

  void project(std::size_t most);
  void enter(std::size_t most);

  ProjectedDiagram& diagram_;
  const FlatArray<Cap>& caps_;
  FlatArray<SiteId> ids_;  // those with a circle, as far as known yet
  Step step_ = Step::kProject;
  std::size_t done_ = 0;  // number of ids_ done in this step
  std::size_t circleCount_ = 0;
  FlatArray<double> circles_;  // x, y, r of the sites with a circle, until they are staged
  std::optional<BulkInsertion>
      insertion_;  // the last member: it is undone while the ids still exist
};

}  // namespace apollonius::internal::sphere
