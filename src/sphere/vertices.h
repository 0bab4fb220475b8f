// Voronoi vertices of the sphere.
#pragma once

#include <array>

#include "base/flat_array.h"
#include "sphere/projected_diagram.h"

namespace apollonius::internal::sphere {

/// The centre of an empty cap that touches three sites, and its radius, the common distance.
struct SphericalVertex {
  Direction point;
  double clearance = 0;  ///< in radians
};

/// Solves the three equations of a vertex, starting from an approximation. Accurate to some 10^-15
/// radians where the sites determine it that well.
[[nodiscard]] SphericalVertex refined(const SphericalVertex& start,
                                      const std::array<const Cap*, 3>& caps);

/// The vertices of faces, each computed when it is first asked for. Vertices at the ends of an edge
/// that is as short as 2^-42 radians, or as rounding, are the same: where more than three sites
/// touch one cap, the faces of that cap have one vertex.
class SphericalVertices {
 public:
  /// Which faces will be needed: with kAll, each has its own place in an array.
  enum class Of : bool { kSome, kAll };

  /// The diagram must stay as it is. Throws std::bad_alloc.
  SphericalVertices(const ProjectedDiagram& diagram, Of of)
      : diagram_(diagram),
        isDirect_(of == Of::kAll),
        entries_(isDirect_ ? diagram.graph().faceSlots() : 64) {}

  /// Throws std::bad_alloc.
  [[nodiscard]] const SphericalVertex& operator[](FaceId face);

 private:
  // With kSome, a hash table by face, at most half full: the cost of one cell is that of its faces.
  struct Entry {
    FaceId face = kNoFace;
    FaceId same = kNoFace;  // the face that stands for this face's vertex; kNoFace if not known yet
    SphericalVertex vertex = {};
    bool isRefined = false;  // no two of the vertex's sites are close
  };
  [[nodiscard]] std::size_t placeOf(FaceId face) const;
  /// The entry of a face, with the vertex of this face alone.
  [[nodiscard]] Entry& entryOf(FaceId face);
  void grow();
  [[nodiscard]] Entry computed(FaceId face) const;
  void findSame(FaceId face);

  const ProjectedDiagram& diagram_;
  bool isDirect_;  // are entries_ by face, rather than a hash table?
  FlatArray<Entry> entries_;
  std::size_t used_ = 0;
  FlatArray<FaceId> reached_;  // scratch
};

}  // namespace apollonius::internal::sphere
