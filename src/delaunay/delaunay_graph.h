// One Delaunay graph together with its sites: an additively weighted Voronoi diagram in its dual
// form, without hidden sites. The diagram proper is one of these for all visible sites, plus
// smaller ones for location (hierarchy.h); deletions build a scratch one of a site's neighbours
// (remove.h).
//
// Vertices are the caller's numbers (1, 2, …; 0 is infinity): the caller that inserts a site
// chooses its vertex.
#pragma once

#include <cstddef>
#include <span>
#include <utility>

#include "base/flat_array.h"
#include "delaunay/conflict.h"
#include "predicate/circle_fan.h"
#include "predicate/predicates.h"
#include "predicate/shadow_check.h"
#include "predicate/site.h"
#include "predicate/stage_counts.h"
#include "predicate/voronoi_circle.h"
#include "topology/graph.h"

namespace apollonius::internal {

/// How a walk to the nearest site searches for a nearer one: among all neighbours (paper, section
/// 4, procedure NearestNeighbor), or only in the direction of the point.
enum class Walk : unsigned char { kAllNeighbors, kSectors };

class Proof;

class DelaunayGraph {
 public:
  // --- Reading

  [[nodiscard]] const Graph& graph() const { return graph_; }
  [[nodiscard]] std::size_t visibleCount() const { return visibleCount_; }
  [[nodiscard]] bool isVisible(VertexId v) const {
    return graph_.hasVertex(v) || (visibleCount_ == 1 && v == recent_);
  }
  /// Some visible vertex, usually that of the last change; kNoVertex if there is none.
  [[nodiscard]] VertexId anyVisible() const { return recent_; }
  [[nodiscard]] const Site& site(VertexId v) const { return sites_[index(v)]; }
  [[nodiscard]] Corner corner(VertexId v) const { return v == kInfinity ? nullptr : &site(v); }
  /// Voronoi circle of a face. After restore() all circles are missing. Each is computed when it is
  /// first asked for, from the sites as they are then. So before visible sites are moved, the
  /// circles around them must be asked for.
  [[nodiscard]] const VoronoiCircle& circle(FaceId f) const {
    if (cachedCircle(f).isMissing()) computeCircle(f);
    return cachedCircle(f);
  }
  /// Circle of a face, or kMissingCircle: for filters, and for loops after computeMissingCircles().
  [[nodiscard]] const VoronoiCircle& cachedCircle(FaceId f) const { return circles_[index(f)]; }
  /// Computes all missing circles, two by two, which is faster than one by one. Throws
  /// std::bad_alloc.
  void computeMissingCircles() const;
  /// The Voronoi edge dual to h, with h's origin on its left.
  [[nodiscard]] EdgeCorners edge(HalfedgeId h) const {
    return {corner(graph_.origin(h)), corner(graph_.target(h)), corner(graph_.apex(h)),
            corner(graph_.apex(graph_.twin(h)))};
  }
  /// Is the Voronoi edge dual to h a point, because both its ends are one vertex of more than three
  /// sites? Exact.
  [[nodiscard]] bool isPoint(HalfedgeId h) const;
  /// A face's vertex for output: precise, with the same bits after any history. Where more than
  /// three sites touch one circle, all faces of that vertex get the same bits. A half-plane is that
  /// of circle().
  [[nodiscard]] VoronoiCircle voronoiVertex(FaceId f) const;
  [[nodiscard]] bool isFaceInConflict(FaceId f, const Site& q) const {
    const MaybeSign filtered =
        circleFilter(cachedCircle(f), q);  // decides nearly all cases without looking up a corner
    stages::counts().vertexAtOnce += filtered.known;
    return filtered.known && !kShadowCheck ? filtered.sign == Sign::kPositive
                                           : isFaceInConflictByCorners(f, q);
  }

  /// The visible site nearest to (x, y); ties go to the largest in the order of precedes().
  struct Located {
    VertexId nearest = kNoVertex;
    HalfedgeId sector = kNoHalfedge;  ///< the half-edge there whose range of directions holds the
                                      ///< point; kNoHalfedge if that is not known
  };
  /// Finds the nearest site by a walk from `start`, as insert() does. REQUIRES: a visible site.
  [[nodiscard]] Located locate(double x, double y, VertexId start,
                               Walk walk = Walk::kSectors) const;

  // --- Changing: each either succeeds or throws std::bad_alloc and has changed nothing

  /// Makes room for vertices of index < slots.
  void reserve(std::size_t slots);
  /// Makes room for the sites of vertices of index < slots.
  void reserveSites(std::size_t slots) {
    if (sites_.size() < slots) sites_.resize(slots);
  }
  /// Makes room for the faces of this many more visible sites, in one piece.
  void reserveBulk(std::size_t sites);

  /// Writes the site of a vertex that is not visible, so that remove() can consider it. REQUIRES:
  /// reserve or reserveSites.
  void setSite(VertexId v, const Site& site) { sites_[index(v)] = site; }

  /// Finds the conflict region of q by a walk from a visible site, and returns kNoVertex; or
  /// returns the site that covers q, which then has no region. REQUIRES: at least two visible
  /// sites.
  [[nodiscard]] VertexId findConflict(ConflictSearch& conflicts, const Site& q, VertexId start,
                                      Walk walk) const;

  /// The effects of inserting a site.
  struct Insertion {
    VertexId cover;           ///< the visible site that covers it (then nothing else), or kNoVertex
    std::size_t degree;       ///< its degree
    std::size_t mostCovered;  ///< at most this many visible sites get hidden
    std::size_t returnRoom;   ///< to reserve (reserveReturn) if it may have to be removed again
  };
  /// Finds where the site of v (setSite) belongs, and makes all room for inserting it. Walks there
  /// from `start`, or from some visible vertex if that is not one: starts are hints, which
  /// diagram/location_index.h keeps. Paper, section 3. REQUIRES: v is not visible.
  [[nodiscard]] Insertion prepareInsertion(VertexId v, VertexId start, Walk walk = Walk::kSectors);
  /// Prepares instead that the site of v takes the place of an identical one, which is the cover
  /// that prepareInsertion() has found. Cost: the degree.
  [[nodiscard]] Insertion prepareReplacing(VertexId v, VertexId twin);
  /// Inserts the site prepared. Returns the vertices that it hides; valid until the next change.
  /// REQUIRES: prepareReplacing() of v was the last call, or prepareInsertion(), which found no
  /// cover.
  std::span<const VertexId> insertPrepared(VertexId v) noexcept;
  /// Prepares and inserts.
  void insert(VertexId v, VertexId start, Walk walk = Walk::kSectors) {
    if (prepareInsertion(v, start, walk).cover == kNoVertex) (void)insertPrepared(v);
  }

  /// Removes v and fills its star with a patch, whose faces have these circles, and which has
  /// `newSites` new sites (for the rest see Graph::replaceStar). With `mayReturn`, makes all room
  /// for inserting v again.
  void replaceStar(VertexId v, std::span<const HalfedgeId> link,
                   std::span<const Graph::PatchFace> patch, std::span<const VoronoiCircle> circles,
                   std::size_t newSites, bool mayReturn);
  /// Makes this vertex the only visible one; none for kNoVertex.
  void becomeSingle(VertexId v) noexcept;

  /// Replaces or computes the circle of a face whose corners have moved.
  void swapCircle(FaceId f, VoronoiCircle& circle) { std::swap(circles_[index(f)], circle); }
  void computeCircle(FaceId f) const;
  /// Flips an edge (Graph::flip()); the circles are still those of the former faces.
  void flip(HalfedgeId h) { graph_.flip(h); }
  /// Restores a former graph, or keeps the present one if `graph` is empty; then circles have to be
  /// computed. Needs no memory. REQUIRES: an empty graph, or a former one of this object.
  void restoreGraph(const Graph& graph) noexcept;

  /// Makes room for searches and changes of this many faces and sides. Room for new faces is left
  /// out, as the changes undo others.
  void reserveReturn(std::size_t facesAndSides);

  /// Forgets all sites but keeps the room.
  void clear() noexcept;

  /// Snapshots (snapshot.cpp): everything except the sites, which are set before restore(). That
  /// fails if the data are no surface, and the graph is then unusable; a proof tells whether it is
  /// the diagram of the sites.
  void save(WordWriter& out, std::size_t vertexSlots) const;
  [[nodiscard]] bool restore(WordReader& in, std::size_t faceSlots);
  /// Begins the proof that the graph is the Delaunay graph of its sites (proof.h), which computes
  /// the circles of all faces. Nothing else may be done until endProof(). Throws std::bad_alloc.
  [[nodiscard]] Proof beginProof();
  /// Ends the proof. True if the graph is proved.
  [[nodiscard]] bool endProof(const Proof& proof);

  // A restored graph that has not been proved may be any graph on a closed surface. Walks in it end
  // and stay within the arrays; all else that operations rely on is checked before they commit.
  [[nodiscard]] bool isProven() const { return isProven_; }
  /// Has the graph turned out not to be that of its sites? Then it is unusable until clear().
  [[nodiscard]] bool isBroken() const { return isBroken_; }
  /// Checks what holds in every Delaunay graph. If it does not hold here, an unproven graph is
  /// broken, which throws; else the code is.
  void requireConsistent(bool holds, const char* name) const {
    if (!holds) markCorrupt(name);
  }

  /// The first broken invariant, exactly checked, or nullptr; `where` receives an id that it names.
  [[nodiscard]] const char* check(std::uint32_t& where) const;

 private:
  friend class DiagramBreaker;  // tests break a structure on purpose

  [[nodiscard]] VertexId visibleStart(VertexId hint) const {
    return isVisible(hint) ? hint : recent_;
  }
  [[nodiscard]] Located walkAllNeighbors(double x, double y, VertexId start) const;
  [[nodiscard]] Located walkSectors(double x, double y, VertexId start) const;
  void shadowCheckNearest(VertexId v, double x, double y) const;
  [[nodiscard]] bool isFaceInConflictByCorners(FaceId f, const Site& q) const;
  [[nodiscard]] Insertion prepareBesideOne(VertexId v);
  [[nodiscard]] Insertion prepareCoveringAll(VertexId v);
  [[nodiscard]] bool isSameVertex(HalfedgeId h) const;
  void markCorrupt(const char* name) const;
  /// Makes room for an operation on the graph, newFaces_ and newCircles_ included.
  void reserveFaces(std::size_t removed, std::size_t created);
  [[nodiscard]] std::span<FaceId> newFaces(std::size_t created) {
    return {newFaces_.data(), created};
  }
  /// After the operation: newCircles_ become the circles of newFaces_.
  void takeCircles(std::size_t created) noexcept {
    for (std::size_t k = 0; k < created; ++k) circles_[index(newFaces_[k])] = newCircles_[k];
  }

  FlatArray<Site> sites_;                     // by vertex
  Graph graph_;                               // has faces from two visible sites on
  mutable FlatArray<VoronoiCircle> circles_;  // by face; mutable only where one is missing
  mutable bool mayMissCircles_ = false;
  bool isProven_ = true;
  mutable bool isBroken_ = false;
  std::size_t visibleCount_ = 0;
  VertexId recent_ = kNoVertex;  // visible; the only one if visibleCount_ is 1

  /// How the prepared site enters: as the only one, beside another, in the hole of its conflict
  /// region, in the place of all, or in that of an identical one.
  enum class Entry : unsigned char { kAlone, kBesideOne, kInHole, kCoveringAll, kReplacing };
  Entry entry_ = Entry::kAlone;
  ConflictSearch conflicts_;
  CircleFan fan_;
  FlatArray<FaceId> newFaces_;  // scratch
  FlatArray<VoronoiCircle>
      newCircles_;  // scratch: computed before the graph changes, as that may take memory
  FlatArray<VertexId> covered_;  // scratch
  std::size_t returnRoom_ = 0;   // that reserveReturn() has made
};

}  // namespace apollonius::internal
