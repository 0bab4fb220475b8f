// The conflict region of a new site: the part of the Voronoi skeleton that its cell will swallow
// (paper, section 3.2), as faces, and the boundary of the hole that they leave. Reports, never
// changes the graph.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "base/flat_array.h"
#include "predicate/site.h"
#include "topology/ids.h"

namespace apollonius::internal {

class DelaunayGraph;

class ConflictSearch {
 public:
  /// Finds the conflict region of q. `near` is the visible site nearest to q's centre and does not
  /// cover q; `sector` the half-edge there in whose range of directions q's centre lies, or
  /// kNoHalfedge. REQUIRES: at least two visible sites. Cost: O(size of the region), plus the
  /// degree of `near` without a sector.
  void find(const DelaunayGraph& delaunay, const Site& q, VertexId near, HalfedgeId sector);

  /// Finds the conflict region without location: looks for a conflict at a few faces of a visible
  /// site close to q's centre. Returns false, with no region, if there is none; else q is not
  /// covered. REQUIRES: at least two visible sites.
  [[nodiscard]] bool findBeside(const DelaunayGraph& delaunay, const Site& q, VertexId close);

  /// Makes room for a region of this many faces with a boundary of this many sides.
  void reserveRegion(std::size_t faces, std::size_t sides) { makeRoom(std::max(faces, sides)); }

  /// Are the faces a disk, with the boundary around them and no vertex within except those that q
  /// covers? In a Delaunay graph they are. Throws std::bad_alloc.
  [[nodiscard]] bool isDisk() const;

  void reserve(std::size_t faces) { marks_.reserve((faces + kWord - 1) / kWord); }

  /// The faces in conflict; empty if q's cell lies within one edge.
  [[nodiscard]] std::span<const FaceId> faces() const { return faces_; }
  [[nodiscard]] bool isInRegion(FaceId f) const {
    return (marks_[index(f) / kWord] & mark(f)) != 0;
  }
  /// The hole's boundary from inside, counter-clockwise, as Graph::starHole wants it; empty if q
  /// covers every site.
  [[nodiscard]] std::span<const HalfedgeId> boundary() const { return boundary_; }
  /// May the boundary have both halves of an edge (a slit, Graph::starHole)?
  [[nodiscard]] bool mayHaveSlits() const { return mayHaveSlits_; }

 private:
  void begin(const DelaunayGraph& delaunay, const Site& q);
  [[nodiscard]] inline bool isEntirelyInConflict(HalfedgeId h, HalfedgeId twin,
                                                 const Site& q) const;
  [[nodiscard]] bool startAt(FaceId f);
  void startAtConflict(FaceId f);
  [[nodiscard]] bool startWithin(HalfedgeId h);
  [[nodiscard]] bool startInSector(HalfedgeId sector);
  void startAround(VertexId near);
  void expand();
  void makeRoom(std::size_t faces);
  inline void enter(FaceId f);
  [[nodiscard]] static std::uint32_t mark(FaceId f) {
    return std::uint32_t{1} << static_cast<std::uint32_t>(f) % kWord;
  }

  static constexpr std::uint32_t kWord = 32;

  const DelaunayGraph* delaunay_ = nullptr;  // during find only
  const Site* q_ = nullptr;
  bool mayHaveSlits_ = false;
  FlatArray<std::uint32_t> marks_;  // one bit a face; of the faces in faces_
  FlatArray<HalfedgeId> stack_;
  FlatArray<FaceId> faces_;
  FlatArray<HalfedgeId> boundary_;
};

}  // namespace apollonius::internal
