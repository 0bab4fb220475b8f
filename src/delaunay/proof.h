// The proof that a graph is the Delaunay graph of its sites, in linear time: for unverified
// snapshots, and for validate().
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/flat_array.h"
#include "predicate/voronoi_circle.h"
#include "topology/graph.h"

namespace apollonius::internal {

class DelaunayGraph;

/// The proof, in steps.
///
/// The conditions, each about one face, one edge, or the hull:
///   1. in a face no site covers another, and its Voronoi circle exists in that orientation;
///   2. along each edge its two ends come in their order, and where they coincide the canonical
///      rule has chosen the diagonal;
///   3. around infinity the normals of the half-planes make one turn.
/// That they suffice: docs/PROOFS.md, "Delaunay graph". That the surface is connected, and a
/// sphere, follows.
class Proof {
 public:
  /// `circles` receives the circles of the faces; those kept in the diagram are not used.
  /// REQUIRES: a closed surface with infinity on it, and at least two sites; or an empty graph.
  /// Throws std::bad_alloc.
  Proof(const DelaunayGraph& delaunay, FlatArray<VoronoiCircle>& circles);

  /// Checks at most this many more faces or edges. True if all are checked, or a condition does not
  /// hold.
  bool advance(std::size_t most);
  /// A text that names the condition that does not hold; nullptr as long as all do. where() is the
  /// id that the text refers to.
  [[nodiscard]] const char* contradiction() const { return what_; }
  [[nodiscard]] std::uint32_t where() const { return where_; }
  /// The share that has been checked, 0 to 1.
  [[nodiscard]] double progress() const;
  /// Condition 3 alone, exactly. REQUIRES: the circles at infinity are those of the faces. Cost:
  /// O(sites on the hull).
  [[nodiscard]] bool hullTurnsOnce() const;

 private:
  enum class Step : std::uint8_t { kFaces, kEdges, kHull };

  void fail(const char* what, HalfedgeId h);
  void lookAtFaces(std::uint32_t end);
  void lookAtFace(FaceId f);
  void lookAtEdges(std::uint32_t end);
  [[nodiscard]] const VoronoiCircle& circle(HalfedgeId h) const {
    return circles_[index(faceOf(h))];
  }

  const DelaunayGraph& delaunay_;
  const Graph& graph_;
  FlatArray<VoronoiCircle>& circles_;
  Step step_ = Step::kFaces;
  std::uint32_t next_ = 0;  // face or half-edge
  const char* what_ = nullptr;
  std::uint32_t where_ = 0;
};

/// Runs the whole proof. Returns the condition that does not hold, and `where` receives an id that
/// it names; or nullptr if the graph is proved.
[[nodiscard]] const char* findContradiction(const DelaunayGraph& delaunay,
                                            FlatArray<VoronoiCircle>& circles,
                                            std::uint32_t& where);

}  // namespace apollonius::internal
