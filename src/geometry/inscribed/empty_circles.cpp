// Along an edge, and along a straight side of the window inside one cell, the distance to the
// nearest site is convex, so it is largest at an end. Hence the candidates are Voronoi vertices in
// the window, the points where edges cross its border, and its corners. All but the corners are the
// ends of the edges as the window clips them.
//
// Circles inside the window must not reach beyond its border either. A candidate that does not is
// one of these circles. In the cells around the others the largest circle may touch the border: it
// is looked for (widest_place.h), those with the farthest candidates first, and only until enough
// circles are found.
#include "geometry/inscribed/empty_circles.h"

#include <algorithm>
#include <span>

#include "base/infinite.h"
#include "diagram/queries.h"
#include "geometry/inscribed/inner_circle.h"

namespace apollonius::internal {

namespace {

/// The end of an edge, with the cells beside it; or a corner of the window.
struct Candidate {
  Point at;
  Slot cells[2] = {kNoSlot, kNoSlot};
  double r = 0;
  SiteId site = kNoSite;  // one at that distance
};

/// The largest one is on top of a heap.
bool isBelow(const Candidate& a, const Candidate& b) {
  return a.r != b.r ? a.r < b.r : isLeftOf(b.at, a.at);
}

void pushOnto(FlatArray<Candidate>& heap, const Candidate& one) {
  heap.push_back(one);
  std::push_heap(heap.begin(), heap.end(), isBelow);
}
Candidate popFrom(FlatArray<Candidate>& heap) {
  std::pop_heap(heap.begin(), heap.end(), isBelow);
  const Candidate one = heap.back();
  heap.pop_back();
  return one;
}

class EndLister final : public EdgeVisitor {  // NOLINT: nothing derives from it
 public:
  EndLister(const DiagramCore& core, FlatArray<Candidate>& ends) : core_(core), ends_(ends) {}
  void visit(HalfedgeId h, const EdgePart& piece) override {
    const Graph& graph = core_.delaunay().graph();
    const Slot a = slotOf(graph.origin(h)), b = slotOf(graph.target(h));
    for (const Point p : {piece.curve.p0, piece.curve.p2}) ends_.push_back({p, {a, b}});
  }

 private:
  const DiagramCore& core_;
  FlatArray<Candidate>& ends_;
};

class Finder {
 public:
  Finder(const DiagramCore& core, const Clipping& window) : core_(core), window_(window) {}

  /// False if a search does not end.
  bool list(std::size_t most, bool inside) {
    listCandidates();
    if (inside) return listInside(most);
    while (!candidates_.empty() && chosen_.size() < most) choose(popFrom(candidates_));
    return true;
  }

  [[nodiscard]] std::span<const Candidate> chosen() const { return chosen_; }

 private:
  void listCandidates() {
    EndLister lister(core_, candidates_);
    window_.visitEdges(lister);
    window_.visitRings([&](std::span<const Point> ring) {
      for (const Point corner : ring) candidates_.push_back({corner});
    });
    FlatArray<double> xy(2 * candidates_.size()), distances(candidates_.size());
    FlatArray<SiteId> sites(candidates_.size());
    for (std::size_t k = 0; k < candidates_.size(); ++k) {
      xy[2 * k] = candidates_[k].at.x;
      xy[2 * k + 1] = candidates_[k].at.y;
    }
    listNearest(core_, xy, kInfinite, sites, distances);
    for (std::size_t k = 0; k < candidates_.size(); ++k) {
      candidates_[k].r = distances[k];
      candidates_[k].site = sites[k];
    }
    std::make_heap(candidates_.begin(), candidates_.end(), isBelow);
  }

  /// Takes a circle whose centre is in none before it, nor where that of one is.
  void choose(const Candidate& circle) {
    const bool isApart = std::all_of(chosen_.begin(), chosen_.end(), [&](const Candidate& one) {
      const double away = length(one.at - circle.at);
      return !(away < one.r || away == 0);
    });
    if (isApart) chosen_.push_back(circle);
  }

  bool listInside(std::size_t most) {
    BorderTree border, outline;
    border.clear(0);
    FlatArray<Conic> sides, curves;
    window_.visitRings([&](std::span<const Point> ring) {
      sides.clear();
      for (std::size_t k = 0; k < ring.size(); ++k)
        sides.push_back(Conic::segment(ring[k], ring[k + 1 < ring.size() ? k + 1 : 0]));
      border.addRing(sides);
    });
    WidestPlace search(border);
    const double grain = grainOf(window_.box());
    const auto cells = window_.cells(Parts::kWithArea);
    FlatArray<char> isAsked(core_.ids().slots(), 0);
    FlatArray<Candidate> places;  // a heap of those that were found in cells
    // False if the search does not end.
    const auto look = [&](Slot slot, const Place& known, double largest) {
      if (isAsked[slot] != 0) return true;
      isAsked[slot] = 1;
      const Cell& cell = cells->find(slot);
      if (cell.pieces.empty()) return true;  // too thin to have a part
      copyCurves(cell, curves);
      outline.clear(grain / 2);
      for (std::size_t k = 0; k < cell.ringCount(); ++k)
        outline.addRing(
            std::span(curves).subspan(cell.starts[k], cell.starts[k + 1] - cell.starts[k]));
      const Site& site = core_.site(slot);
      const CellOfObstacle own{{{site.x, site.y}, site.r}, outline};
      Place best = known;
      if (!search.find(boxOf(curves), grain, best, &own)) return false;
      // A larger one is beside a candidate of the cell that was taken or is in another circle.
      if (best.r <= largest) pushOnto(places, {best.at, {}, best.r, core_.ids().idOf(slot)});
      return true;
    };
    while (chosen_.size() < most && !(candidates_.empty() && places.empty())) {
      if (candidates_.empty() || (!places.empty() && places[0].r >= candidates_[0].r)) {
        choose(popFrom(places));
        continue;
      }
      const Candidate one = popFrom(candidates_);
      const double room = border.distance(one.at, 0, -1);
      if (room >= one.r) {
        choose(one);
        continue;
      }
      const bool isCorner = one.cells[0] == kNoSlot;
      for (const Slot slot : one.cells)
        if (!look(isCorner ? core_.ids().slotOf(one.site) : slot, {one.at, room}, one.r))
          return false;
    }
    return true;
  }

  const DiagramCore& core_;
  const Clipping& window_;
  FlatArray<Candidate> candidates_;  // a heap
  FlatArray<Candidate> chosen_;
};

}  // namespace

bool listEmptyCircles(const DiagramCore& core, const Clipping& window, std::size_t most,
                      bool inside, VertexArrays& circles) {
  circles.coordinates.clear();
  circles.clearance.clear();
  circles.sites.clear();
  if (core.visibleCount() == 0) return true;
  Finder finder(core, window);
  if (!finder.list(most, inside)) return false;
  for (const Candidate& one : finder.chosen()) {
    circles.coordinates.push_back(one.at.x);
    circles.coordinates.push_back(one.at.y);
    circles.clearance.push_back(one.r);
    circles.sites.push_back(one.site);
  }
  return true;
}

}  // namespace apollonius::internal
