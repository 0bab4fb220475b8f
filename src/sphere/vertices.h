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

/// The three equations of a vertex solved from an approximation. Accurate to some 10^-15 radians
/// where the sites determine it that well.
[[nodiscard]] SphericalVertex refined(const SphericalVertex& start,
                                      const std::array<const Cap*, 3>& caps);

/// The vertices of faces, each computed when it is first asked for. Vertices at the ends of an edge
/// that is as short as 2^-42 radians, or as rounding, are the same: where more than three sites
/// touch one cap, the faces of that cap have one vertex.
class SphericalVertices {
 public:
  /// Which faces will be asked for: with all of them, each has its place in an array at once.
  enum class Of : bool { kSome, kAll };

  /// The diagram must stay as it is. Throws std::bad_alloc.
  SphericalVertices(const ProjectedDiagram& diagram, Of of)
      : diagram_(diagram),
        isDirect_(of == Of::kAll),
        entries_(isDirect_ ? diagram.graph().faceSlots() : 64) {}

  /// Throws std::bad_alloc.
  [[nodiscard]] const SphericalVertex& operator[](FaceId face);

 private:
  // In a table by face, at most half full, one cell costs what it has of them.
  struct Entry {
    FaceId face = kNoFace;
    FaceId same = kNoFace;  // whose vertex this face has; kNoFace if that is not known yet
    SphericalVertex vertex = {};
    bool isRefined = false;  // no two of the sites are close
  };
  [[nodiscard]] std::size_t placeOf(FaceId face) const;
  /// With the vertex of this face alone.
  [[nodiscard]] Entry& entryOf(FaceId face);
  void grow();
  [[nodiscard]] Entry computed(FaceId face) const;
  void findSame(FaceId face);

  const ProjectedDiagram& diagram_;
  bool isDirect_;  // entries_ are by face, and a table otherwise
  FlatArray<Entry> entries_;
  std::size_t used_ = 0;
  FlatArray<FaceId> reached_;  // scratch
};

}  // namespace apollonius::internal::sphere
