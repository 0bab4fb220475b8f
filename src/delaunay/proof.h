// The proof that a graph is the Delaunay graph of its sites, in linear time: for snapshots from
// strangers, and for validate().
#pragma once

#include <cstdint>

#include "base/flat_array.h"
#include "predicate/voronoi_circle.h"

namespace apollonius::internal {

class DelaunayGraph;

/// What contradicts it, with `where` receiving an id that it names; or nullptr, and then it is
/// proved. `circles` becomes the circles of the faces; what the diagram keeps of them is not looked
/// at. REQUIRES: a closed surface with infinity on it, and at least two sites. Throws
/// std::bad_alloc.
///
/// The conditions, all of them of one face, one edge, or the hull:
///   1. in a face no site covers another, and its Voronoi circle exists in that orientation;
///   2. along each edge its two ends come in their order, and where they coincide the canonical
///      rule has chosen the diagonal;
///   3. around infinity the normals of the half-planes make one turn.
/// That they suffice: docs/PROOFS.md, "Delaunay graph". That the surface is connected, and a
/// sphere, follows.
[[nodiscard]] const char* findContradiction(const DelaunayGraph& delaunay,
                                            FlatArray<VoronoiCircle>& circles,
                                            std::uint32_t& where);

}  // namespace apollonius::internal
