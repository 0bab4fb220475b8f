#include "delaunay/remove.h"

#include <algorithm>
#include <new>

#include "number/invariant.h"
#include "predicate/predicates.h"

namespace apollonius::internal {

std::span<const Remover::Outcome> Remover::remove(DelaunayGraph& delaunay, VertexId v,
                                                  std::span<const VertexId> hidden,
                                                  bool mayReturn) {
  invariant(delaunay.isVisible(v), "a site that is removed from a graph is there");
  outcomes_.clear();
  collectLink(delaunay.graph(), v);
  const std::size_t remaining = delaunay.visibleCount() - 1;
  delaunay.requireConsistent(remaining == 0 || !link_.empty(), "a visible site is in the graph");

  if (hidden.empty() && remaining < 2) {
    delaunay.becomeSingle(remaining == 0 ? kNoVertex
                          : delaunay.graph().origin(link_[0]) != kInfinity
                              ? delaunay.graph().origin(link_[0])
                              : delaunay.graph().target(link_[0]));
    return outcomes_;
  }
  if (hidden.empty() && link_.size() == 2) {
    delaunay.replaceStar(v, link_, {}, {}, 0, mayReturn);  // the two edges opposite to v become one
    return outcomes_;
  }
  if (hidden.empty() && ears_.fill(delaunay, v, link_)) {
    delaunay.replaceStar(v, link_, ears_.patch(), ears_.circles(), 0, mayReturn);
    return outcomes_;
  }

  buildSmall(delaunay, hidden);
  outcomes_.reserve(hidden.size());
  const auto firstHidden = static_cast<std::uint32_t>(global_.size() - hidden.size());
  for (const VertexId local : fallen_) {
    if (index(local) >= firstHidden)
      outcomes_.push_back({global(local), global(cover_[index(local)])});
  }
  const std::size_t revived = hidden.size() - outcomes_.size();
  for (std::size_t k = firstHidden; k < global_.size(); ++k) {
    if (cover_[k] == kNoVertex) outcomes_.push_back({global_[k], kNoVertex});
  }

  if (remaining + revived < 2) {
    delaunay.becomeSingle(small_.visibleCount() == 0 ? kNoVertex : global(small_.anyVisible()));
    return outcomes_;
  }
  if (!delaunay.isProven())
    delaunay.requireConsistent(hasAllNeighbors(delaunay.graph()), "no neighbour is covered");
  findPatch(delaunay, v);
  delaunay.replaceStar(v, link_, patch_, patchCircles_, revived, mayReturn);
  return outcomes_;
}

/// A site of degree d with h hidden sites needs a small diagram of at most d + h sites, with at
/// most twice as many faces.
void Remover::reserve(std::size_t sites) {
  if (sites <= room_) return;
  sites = std::max(sites, 2 * room_);
  const std::size_t faces = 2 * (sites + 1);
  small_.reserve(sites + 1);
  small_.reserveBulk(sites);
  small_.reserveReturn(faces);
  conflicts_.reserve(faces);
  conflicts_.reserveRegion(faces, faces);
  for (FlatArray<VertexId>* array : {&global_, &cover_, &fallen_, &order_, &hidden_})
    array->reserve(sites + 1);
  link_.reserve(sites);
  outcomes_.reserve(sites);
  adopted_.reserve(sites);
  patchOf_.reserve(faces);
  linkOf_.reserve(3 * faces);
  patchFaces_.reserve(faces);
  patch_.reserve(faces);
  patchCircles_.reserve(faces);
  ears_.reserve();
  room_ = sites;
}

void Remover::collectLink(const Graph& graph, VertexId v) {
  link_.clear();
  for (const HalfedgeId h : graph.star(v)) link_.push_back(next(h));
}

/// Inserts the neighbours in rounds of halved strides along the link, each with a walk from its
/// predecessor of an earlier round: the walks stay short, and sorted input is no worst case. A
/// neighbour that occurs twice in the link is covered by its first occurrence, and so drops out.
void Remover::buildSmall(const DelaunayGraph& delaunay, std::span<const VertexId> hidden) {
  const std::size_t d = link_.size();
  small_.clear();
  small_.reserve(d + hidden.size() + 1);
  global_.assign(1, kInfinity);
  cover_.assign(1, kNoVertex);
  fallen_.clear();
  global_.reserve(d + hidden.size() + 1);
  cover_.reserve(d + hidden.size() + 1);
  fallen_.reserve(d + hidden.size());

  order_.assign(d, kNoVertex);  // local vertex of link position, once it has entered
  const auto enter = [&](std::size_t position, std::size_t predecessor) {
    const VertexId u = delaunay.graph().origin(link_[position]);
    VertexId start = predecessor < d ? order_[predecessor] : kNoVertex;
    if (u != kInfinity) start = addLocal(delaunay, u, start);
    order_[position] = start;
  };
  std::size_t stride = 1;
  while (stride < d) stride *= 2;
  if (d > 0) enter(0, d);
  for (; stride >= 1; stride /= 2) {
    for (std::size_t position = stride; position < d; position += 2 * stride)
      enter(position, position - stride);
  }
  for (const VertexId u : hidden) addLocal(delaunay, u, kNoVertex);
}

/// Adds a vertex of the diagram to the small one; returns the visible vertex there: itself or its
/// cover.
VertexId Remover::addLocal(const DelaunayGraph& delaunay, VertexId v, VertexId start) {
  const VertexId local{static_cast<std::uint32_t>(global_.size())};
  global_.push_back(v);
  cover_.push_back(kNoVertex);
  small_.setSite(local, delaunay.site(v));
  const DelaunayGraph::Insertion insertion = small_.prepareInsertion(local, start);
  const auto fall = [&](VertexId fallen, VertexId cover) {
    cover_[index(fallen)] = cover;
    fallen_.push_back(fallen);
  };
  if (insertion.cover != kNoVertex) {
    fall(local, insertion.cover);
    return insertion.cover;
  }
  for (const VertexId covered : small_.insertPrepared(local)) fall(covered, local);
  return local;
}

/// Finds the part of the small diagram with which v would be in conflict. Its boundary is v's link:
/// both are v's neighbours in the diagram of the same sites, and the canonical rule makes them
/// equal in degenerate position, too.
void Remover::findPatch(const DelaunayGraph& delaunay, VertexId v) {
  patchFaces_.clear();
  const Graph& small = small_.graph();
  patchOf_.assign(small.faceSlots(), kNoIndex);
  linkOf_.assign(3 * small.faceSlots(), kNoIndex);
  if (delaunay.visibleCount() == 1) {
    takeAllAsPatch();  // v's cell was the plane
  } else if (small_.visibleCount() > 1) {
    const Site& q = delaunay.site(v);
    const DelaunayGraph::Located near = small_.locate(q.x, q.y, small_.anyVisible());
    if (!delaunay.isProven()) {
      const Site& nearest =
          small_.site(near.nearest);  // may be the same circle again, which had been hidden
      delaunay.requireConsistent(!covers(nearest, q) || covers(q, nearest),
                                 "no neighbour covers a visible site");
    }
    conflicts_.find(small_, q, near.nearest, near.sector);
    patchFaces_.assign(conflicts_.faces());
    if (!patchFaces_.empty()) alignLink(delaunay);
  }
  // Else one neighbour and infinity, or a cell within one edge of the small diagram: degree 2, an
  // empty patch.
  delaunay.requireConsistent(!patchFaces_.empty() || link_.size() == 2,
                             "an empty patch fits a site of degree 2 only");
  makePatch();
}

/// Is each neighbour visible in the small diagram?
bool Remover::hasAllNeighbors(const Graph& graph) const {
  for (std::size_t k = 0; k < link_.size(); ++k) {
    const VertexId u = graph.origin(link_[k]), local = order_[k];
    if (u != kInfinity && (global(local) != u || !small_.isVisible(local))) return false;
  }
  return true;
}

void Remover::takeAllAsPatch() {
  for (const FaceId f : small_.graph().faces()) patchFaces_.push_back(f);
}

/// Numbers the small diagram's boundary as the link. A pair (from, to) occurs in the link of v
/// once: three sites in a given order have at most one Voronoi circle.
void Remover::alignLink(const DelaunayGraph& delaunay) {
  const Graph& graph = delaunay.graph();
  const std::span<const HalfedgeId> boundary = conflicts_.boundary();
  const Graph& small = small_.graph();
  const auto fits = [&](HalfedgeId inner, HalfedgeId link) {
    return global(small.origin(inner)) == graph.origin(link) &&
           global(small.target(inner)) == graph.target(link);
  };
  delaunay.requireConsistent(boundary.size() == link_.size(),
                             "the patch has as many sides as the star");
  std::size_t shift = 0;
  while (shift < boundary.size() && !fits(boundary[shift], link_[0])) ++shift;
  for (std::size_t k = 0; k < boundary.size(); ++k) {
    const HalfedgeId inner = boundary[(k + shift) % boundary.size()];
    delaunay.requireConsistent(fits(inner, link_[k]),
                               "the sides of the patch are those of the star");
    linkOf_[index(inner)] = static_cast<std::uint32_t>(k);
  }
}

void Remover::makePatch() {
  const Graph& small = small_.graph();
  for (std::size_t k = 0; k < patchFaces_.size(); ++k)
    patchOf_[index(patchFaces_[k])] = static_cast<std::uint32_t>(k);
  patch_.resize(patchFaces_.size());
  patchCircles_.resize(patchFaces_.size());
  for (std::size_t k = 0; k < patchFaces_.size(); ++k) {
    patchCircles_[k] = small_.circle(patchFaces_[k]);
    for (unsigned c = 0; c < 3; ++c) {
      const HalfedgeId h = halfedgeOf(patchFaces_[k], c);
      const HalfedgeId across = small.twin(h);
      patch_[k].corners[c] = global(small.origin(h));
      // An edge of which v's cell took only the ends is on the boundary with both sides, though
      // both its faces are in the patch: what lies between the ends is for the big diagram to say.
      const std::uint32_t outside = linkOf_[index(h)];
      patch_[k].across[c] = outside != kNoIndex ? Graph::kOutside | outside
                                                : 3 * patchOf_[index(faceOf(across))] +
                                                      static_cast<std::uint32_t>(index(across) % 3);
    }
  }
}

}  // namespace apollonius::internal
