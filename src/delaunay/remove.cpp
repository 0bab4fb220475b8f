#include "delaunay/remove.h"

#include <algorithm>
#include <new>

#include "diagram/spatial_order.h"
#include "number/invariant.h"
#include "predicate/predicates.h"

namespace apollonius {

std::span<const Remover::Fate> Remover::remove(DelaunayGraph& diagram, VertexId v,
                                               std::span<const VertexId> hidden, bool mayReturn) {
  invariant(diagram.isVisible(v), "a site that is removed from a graph is there");
  mayReturn_ = mayReturn;
  fates_.clear();
  collectLink(diagram.graph(), v);
  const std::size_t remaining = diagram.visibleCount() - 1;
  diagram.demand(remaining == 0 || !link_.empty(), "a visible site has a place in the graph");

  if (hidden.empty() && remaining < 2) {
    becomeSingle(diagram, remaining == 0 ? kNoVertex
                          : diagram.graph().origin(link_[0]) != kInfinity
                              ? diagram.graph().origin(link_[0])
                              : diagram.graph().target(link_[0]));
    return fates_;
  }
  if (hidden.empty() && link_.size() == 2) {
    apply(diagram, v, {}, {});  // the two edges opposite to v become one
    return fates_;
  }
  if (hidden.empty() && ears_.fill(diagram, v, link_)) {
    apply(diagram, v, ears_.patch(), ears_.circles());
    return fates_;
  }

  buildSmall(diagram, hidden);
  fates_.reserve(hidden.size());
  const auto firstHidden = static_cast<std::uint32_t>(global_.size() - hidden.size());
  for (const VertexId local : fallen_) {
    if (index(local) >= firstHidden)
      fates_.push_back({global(local), global(cover_[index(local)])});
  }
  const std::size_t revived = hidden.size() - fates_.size();
  for (std::size_t k = firstHidden; k < global_.size(); ++k) {
    if (cover_[k] == kNoVertex) fates_.push_back({global_[k], kNoVertex});
  }

  if (remaining + revived < 2) {
    becomeSingle(diagram, small_.visibleCount() == 0 ? kNoVertex : global(small_.anyVisible()));
    return fates_;
  }
  if (!diagram.isProven())
    diagram.demand(hasAllNeighbors(diagram.graph()), "no neighbour is covered");
  findPatch(diagram, v);
  apply(diagram, v, patch_, patchCircles_);
  diagram.visibleCount_ += revived;
  return fates_;
}

/// A degree of d with h hidden sites makes a small diagram of d + h sites at most, with no more
/// than twice as many faces.
void Remover::reserve(std::size_t sites) {
  if (sites <= room_) return;
  sites = std::max(sites, 2 * room_);
  const std::size_t faces = 2 * (sites + 1);
  small_.reserve(sites + 1);
  small_.reserveBulk(sites);
  small_.reserveReturn(faces);
  for (FlatArray<VertexId>* array : {&global_, &cover_, &fallen_, &order_, &hidden_})
    array->reserve(sites + 1);
  link_.reserve(sites);
  fates_.reserve(sites);
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
  const HalfedgeId begin = graph.outgoing(v);
  if (begin == kNoHalfedge) return;  // v is the only visible site
  HalfedgeId h = begin;
  do {
    link_.push_back(next(h));
    h = graph.rotateCcw(h);
  } while (h != begin);
}

/// The neighbours enter in rounds of halved strides along the link, each from its predecessor of an
/// earlier round: the walks stay short and the order has no bad cases that a sorted one has. A
/// neighbour that occurs twice in the link is covered by its first occurrence and so falls out by
/// itself.
void Remover::buildSmall(const DelaunayGraph& diagram, std::span<const VertexId> hidden) {
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
    const VertexId u = diagram.graph().origin(link_[position]);
    VertexId start = predecessor < d ? order_[predecessor] : kNoVertex;
    if (u != kInfinity) start = addLocal(diagram, u, start);
    order_[position] = start;
  };
  std::size_t stride = 1;
  while (stride < d) stride *= 2;
  if (d > 0) enter(0, d);
  for (; stride >= 1; stride /= 2) {
    for (std::size_t position = stride; position < d; position += 2 * stride)
      enter(position, position - stride);
  }
  if (hidden.size() < kMany) {
    for (const VertexId u : hidden) addLocal(diagram, u, kNoVertex);
  } else {
    addMany(diagram, hidden);
  }
}

/// In the order of a bulk insertion, each from its predecessor; in any other one walks would be
/// long. So they are where there is no room for that order, as when this undoes an operation that
/// ran out of memory.
void Remover::addMany(const DelaunayGraph& diagram, std::span<const VertexId> hidden) {
  FlatArray<std::uint32_t> order;
  try {
    FlatArray<double> centres;
    centres.reserve(2 * hidden.size());
    for (const VertexId u : hidden) {
      centres.push_back(diagram.site(u).x);
      centres.push_back(diagram.site(u).y);
    }
    order = inRandomizedRounds(hilbertOrder({centres, 2}));
  } catch (const std::bad_alloc&) {
    order = FlatArray<std::uint32_t>();
  }
  for (std::size_t k = 0; k < hidden.size(); ++k)
    addLocal(diagram, hidden[order.empty() ? k : order[k]], kNoVertex);
}

/// Adds a vertex of the diagram to the small one; returns the visible vertex at its place.
VertexId Remover::addLocal(const DelaunayGraph& diagram, VertexId v, VertexId start) {
  const VertexId local{static_cast<std::uint32_t>(global_.size())};
  global_.push_back(v);
  cover_.push_back(kNoVertex);
  small_.setSite(local, diagram.site(v));
  const DelaunayGraph::Insertion insertion = small_.insert(local, start);
  const auto fall = [&](VertexId fallen, VertexId cover) {
    cover_[index(fallen)] = cover;
    fallen_.push_back(fallen);
  };
  if (insertion.cover != kNoVertex) fall(local, insertion.cover);
  for (const VertexId covered : insertion.covered) fall(covered, local);
  return insertion.cover == kNoVertex ? local : insertion.cover;
}

/// The part of the small diagram that v would be in conflict with. Its rim is v's link: both are
/// v's neighbours in the diagram of the same sites, and the canonical rule makes them equal in
/// degenerate position too.
void Remover::findPatch(const DelaunayGraph& diagram, VertexId v) {
  patchFaces_.clear();
  const Graph& small = small_.graph();
  patchOf_.assign(small.faceSlots(), kNoIndex);
  linkOf_.assign(3 * small.faceSlots(), kNoIndex);
  if (diagram.visibleCount() == 1) {
    takeAllAsPatch();  // v's cell was the plane
  } else if (small_.visibleCount() > 1) {
    const Site& q = diagram.site(v);
    const DelaunayGraph::Located near = small_.locate(q.x, q.y, small_.anyVisible());
    if (!diagram.isProven()) {
      const Site& nearest =
          small_.site(near.nearest);  // may be the same circle again, which had been hidden
      diagram.demand(!covers(nearest, q) || covers(q, nearest),
                     "no neighbour covers a visible site");
    }
    small_.conflicts_.find(small_, q, near.nearest, near.sector);
    patchFaces_.assign(small_.conflicts_.faces());
    if (!patchFaces_.empty()) alignLink(diagram);
  }
  // Else one neighbour and infinity, or a cell within one edge of the small diagram: degree 2, an
  // empty patch.
  diagram.demand(!patchFaces_.empty() || link_.size() == 2,
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
  for (std::size_t i = 0; i < small_.graph().faceSlots(); ++i) {
    const FaceId f{static_cast<std::uint32_t>(i)};
    if (small_.graph().isLive(f)) patchFaces_.push_back(f);
  }
}

/// Numbers the small diagram's rim as the link. A pair (from, to) occurs in the link of v once:
/// three sites in a given order have at most one Voronoi circle.
void Remover::alignLink(const DelaunayGraph& diagram) {
  const Graph& graph = diagram.graph();
  const std::span<const HalfedgeId> rim = small_.conflicts_.rim();
  const Graph& small = small_.graph();
  const auto fits = [&](HalfedgeId inner, HalfedgeId link) {
    return global(small.origin(inner)) == graph.origin(link) &&
           global(small.target(inner)) == graph.target(link);
  };
  diagram.demand(rim.size() == link_.size(), "the patch has as many sides as the star");
  std::size_t shift = 0;
  while (shift < rim.size() && !fits(rim[shift], link_[0])) ++shift;
  for (std::size_t k = 0; k < rim.size(); ++k) {
    const HalfedgeId inner = rim[(k + shift) % rim.size()];
    diagram.demand(fits(inner, link_[k]), "the sides of the patch are those of the star");
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
      // An edge of which v's cell took only the ends is on the rim with both sides, though both its
      // faces are in the patch: what lies between the ends is for the big diagram to say.
      const std::uint32_t outside = linkOf_[index(h)];
      patch_[k].across[c] = outside != kNoIndex ? Graph::kOutside | outside
                                                : 3 * patchOf_[index(faceOf(across))] +
                                                      static_cast<std::uint32_t>(index(across) % 3);
    }
  }
}

void Remover::apply(DelaunayGraph& diagram, VertexId v, std::span<const Graph::PatchFace> patch,
                    std::span<const VoronoiCircle> circles) {
  // Two sides of each other would be the sides of a whole sphere.
  const bool isSphere = patch.empty() && diagram.graph().twin(link_[0]) == link_[1];
  diagram.demand(!isSphere, "the star of a site is not all there is");
  diagram.reserveFaces(link_.size(), patch.size());
  if (mayReturn_) diagram.reserveReturn(std::max(link_.size(), patch.size()));
  // Some visible neighbour, should v be the vertex that walks start from.
  const Graph& graph = diagram.graph();
  const VertexId a = patch.empty() ? graph.origin(link_[0]) : patch[0].corners[0];
  const VertexId b = patch.empty() ? graph.target(link_[0]) : patch[0].corners[1];
  const VertexId neighbour = a != kInfinity ? a : b;
  std::copy(circles.begin(), circles.end(), diagram.newCircles_.begin());
  diagram.graph_.replaceStar(v, link_, patch, diagram.newFaces(patch.size()));
  diagram.takeCircles(patch.size());
  --diagram.visibleCount_;
  if (diagram.recent_ == v) diagram.recent_ = neighbour;
}

void Remover::becomeSingle(DelaunayGraph& diagram, VertexId v) {
  diagram.clear();
  diagram.visibleCount_ = v == kNoVertex ? 0 : 1;
  diagram.recent_ = v;
}

}  // namespace apollonius
