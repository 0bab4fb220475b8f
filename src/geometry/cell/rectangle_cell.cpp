#include "geometry/cell/rectangle_cell.h"

#include "geometry/curve/moments.h"
#include "predicate/reference_site.h"

namespace apollonius::internal {

namespace {

/// Where the star of a vertex begins after any history: at the half-edge whose target, and then the
/// next one's, is largest in the order of precedes(). No two neighbours follow each other twice,
/// a b … a b: around a vertex of a planar graph, none alternate.
HalfedgeId firstOfStar(const DelaunayGraph& delaunay, VertexId v) {
  const Graph& graph = delaunay.graph();
  const auto target = [&](HalfedgeId h) { return delaunay.corner(graph.target(h)); };
  HalfedgeId first = graph.outgoing(v);
  Corner largest = target(first);
  for (const HalfedgeId h : graph.star(v)) {
    const Corner a = target(h);
    if (a == largest
            ? !isBetterReference(target(graph.rotateCcw(h)), target(graph.rotateCcw(first)))
            : !isBetterReference(a, largest))
      continue;
    first = h;
    largest = a;
  }
  return first;
}

}  // namespace

const Cell& RectangleCellClipper::find(Slot site) {
  cell_.clear();
  if (core_.ids().state(site) != SiteState::kVisible) return cell_;
  clipEdges(site);
  contacts_.clear();
  for (std::uint32_t k = 0; k < pieces_.size(); ++k) {
    const ClippedPiece& piece = pieces_[k].clipped;
    const auto add = [&](int side, Point p, bool leaves) {
      if (side != kNoSide) contacts_.push_back({side, window_.positionOf(side, p), p, k, leaves});
    };
    add(piece.fromSide, piece.curve.p0, false);
    add(piece.toSide, piece.curve.p2, true);
  }
  if (!contacts_.empty()) {
    link(site);
  } else if (!pieces_.empty()) {
    for (const Piece& piece : pieces_)
      cell_.pieces.push_back({piece.clipped.curve, piece.neighbor});
    closePart();
  } else if (ownerOfWindow(core_, window_) == site) {
    wholeWindow();
  }
  return cell_;
}

/// The parts of the cell's edges inside the window, counter-clockwise about the site, from one edge
/// on after any history.
void RectangleCellClipper::clipEdges(Slot site) {
  pieces_.clear();
  const DelaunayGraph& delaunay = core_.delaunay();
  const Graph& graph = delaunay.graph();
  const VertexId v = vertexOf(site);
  if (!graph.hasVertex(v)) return;  // the only visible site
  ClippedEdge clipped;
  for (const HalfedgeId h : Star<Graph>(graph, firstOfStar(delaunay, v))) {
    if (graph.target(h) != kInfinity) {
      const SiteId neighbor = core_.siteOf(graph.target(h));
      if (startsAtReference(delaunay, h)) {
        clip(h, clipped);
        for (int k = 0; k < clipped.count; ++k)
          pieces_.push_back({clipped.pieces[static_cast<std::size_t>(k)], neighbor});
      } else {
        clip(graph.twin(h), clipped);
        for (int k = clipped.count; k-- > 0;)
          pieces_.push_back({clipped.pieces[static_cast<std::size_t>(k)].reversed(), neighbor});
      }
    }
  }
}

void RectangleCellClipper::clip(HalfedgeId h, ClippedEdge& clipped) {
  if (kept_.empty()) return clipEdge(core_.delaunay(), h, window_, clipped);
  KeptEdge& kept = kept_[index(h) % kMostKept];
  if (kept.halfedge == h) {
    clipped.pieces[0] = kept.piece;
    clipped.count = 1;
    return;
  }
  clipEdge(core_.delaunay(), h, window_, clipped, VertexPrecision::kReproducible, &vertices_);
  if (clipped.count == 1) kept = {clipped.pieces[0], h};
}

/// Joins the pieces, which leave and enter the window, along its border.
void RectangleCellClipper::link(Slot site) {
  linkBorderArcs(core_, site, window_, contacts_, arcs_);
  arcAfter_.assign(pieces_.size(), 0);
  isUsed_.assign(pieces_.size(), 0);
  for (std::uint32_t k = 0; k < arcs_.size(); ++k) arcAfter_[contacts_[arcs_[k].from].piece] = k;
  for (const BorderArc& first : arcs_) {
    std::uint32_t k = contacts_[first.to].piece;
    if (isUsed_[k] != 0) continue;
    while (isUsed_[k] == 0) {
      isUsed_[k] = 1;
      const ClippedPiece& piece = pieces_[k].clipped;
      if (!piece.isTouch || !(piece.curve.p0 == piece.curve.p2))
        cell_.pieces.push_back(
            {piece.curve, pieces_[k].neighbor, kNoSegment, kNoSegment, false, piece.isTouch});
      if (piece.toSide == kNoSide) {
        k = (k + 1) % static_cast<std::uint32_t>(pieces_.size());
        continue;
      }
      const BorderArc& arc = arcs_[arcAfter_[k]];
      addBorder(arc);
      k = contacts_[arc.to].piece;
    }
    closePart();
  }
}

void RectangleCellClipper::addBorder(const BorderArc& arc) {
  Point at = contacts_[arc.from].point;
  const auto lineTo = [&](Point p) {
    if (!(p == at)) cell_.pieces.push_back({Conic::segment(at, p), kNoSite});
    at = p;
  };
  for (int k = 0; k < arc.cornerCount; ++k) lineTo(window_.corner((arc.firstCorner + k) % 4));
  lineTo(contacts_[arc.to].point);
}

void RectangleCellClipper::wholeWindow() {
  for (int k = 0; k < 4; ++k)
    cell_.pieces.push_back(
        {Conic::segment(window_.corner(k), window_.corner((k + 1) % 4)), kNoSite});
  closePart();
}

void RectangleCellClipper::closePart() {
  const std::uint32_t start = cell_.starts.back();
  const auto pieces = std::span(cell_.pieces).subspan(start);
  if (pieces.empty()) return;
  // The area is computed from the part's own first point, which is the same after any history: so a
  // sliver is kept after every history, or after none.
  const auto hasArea = [&] {
    const Area area = areaOf(pieces, window_.nearestTo(pieces.front().curve.p0));
    return area.value > area.rounding;
  };
  if (parts() == Parts::kThinToo || hasArea()) {
    cell_.starts.push_back(static_cast<std::uint32_t>(cell_.pieces.size()));
    cell_.outers.push_back(static_cast<std::uint32_t>(cell_.ringCount()));
  } else {
    cell_.pieces.resize(start);
  }
}

}  // namespace apollonius::internal
