// The invariants of a diagram, exactly checked; the first broken one is named with its ids.
#include <cmath>

#include "diagram/diagram_core.h"
#include "memory/flat_array.h"
#include "predicate/predicates.h"

namespace apollonius {

namespace {

/// Can both be the same circle or half-plane, within their errors? NaNs come with infinite errors.
bool agree(const VoronoiCircle& a, const VoronoiCircle& b) {
  if (a.isHalfPlane() != b.isHalfPlane()) return false;
  const double error = (double{a.error} + double{b.error}) * (1 + 0x1p-20);
  const auto isClose = [](double x, double y, double bound) { return !(std::abs(x - y) > bound); };
  if (!a.isHalfPlane()) return isClose(a.x, b.x, error) && isClose(a.y, b.y, error) && isClose(a.s, b.s, error);
  const double slope = (double{a.slope} + double{b.slope}) * (1 + 0x1p-20);
  return isClose(a.x, b.x, slope) && isClose(a.y, b.y, slope) && isClose(a.s, b.s, error);
}

/// The direction of (x, y) as a number that grows from 0 to 4 in a turn.
double turnOf(double x, double y) {
  const double share = absolute(y) / (absolute(x) + absolute(y));
  if (y >= 0) return x >= 0 ? share : 2 - share;
  return x < 0 ? 2 + share : 4 - share;
}

}  // namespace

const char* DelaunayGraph::check(std::uint32_t& where) const {
  if (const char* broken = graph_.check(where)) return broken;
  std::size_t vertices = 0;
  for (std::size_t v = 1; v < graph_.vertexSlots(); ++v) vertices += graph_.hasVertex(VertexId{static_cast<std::uint32_t>(v)});
  where = static_cast<std::uint32_t>(visibleCount_);
  if (visibleCount_ >= 2 ? vertices != visibleCount_ : vertices != 0) return "the count of visible sites is wrong: count";
  if (visibleCount_ > 0 && (recent_ == kNoVertex || !isVisible(recent_))) return "walks start from a site without a cell: count";

  for (std::size_t i = 0; i < 3 * graph_.faceSlots(); ++i) {
    const HalfedgeId h{static_cast<std::uint32_t>(i)};
    if (!graph_.isLive(faceOf(h))) continue;
    where = static_cast<std::uint32_t>(i);
    const EdgeCorners e = edge(h);
    // Every edge: neither site covers the other; the corner beyond is not in conflict with the face on this side.
    if (e.i != nullptr && e.j != nullptr && covers(*e.i, *e.j)) return "a visible site is covered by a neighbour: half-edge";
    if (e.l != nullptr && e.l != e.k && isVertexInConflict(e.i, e.j, e.k, *e.l)) {
      return "a face is in conflict with the site beyond its edge: half-edge";
    }
    // Every bounded face: its circle exists, and the cached one is this one.
    if (index(h) % 3 != 0) continue;
    if (e.i != nullptr && e.j != nullptr && e.k != nullptr && !hasVoronoiCircle(*e.i, *e.j, *e.k)) {
      return "a face has no Voronoi circle: half-edge";
    }
    if (!agree(circle(faceOf(h)), voronoiCircle(e.i, e.j, e.k))) {
      return "the cached circle of a face is not its circle: half-edge";
    }
  }
  where = 0;
  if (!graph_.isEmpty() && !hullTurnsOnce()) return "the hull turns more than once: half-edge";
  return nullptr;
}

/// Else the graph would be that of several diagrams on top of each other, sewn together. Normals that are too close or too vague to
/// tell which comes first count as one.
bool DelaunayGraph::hullTurnsOnce() const {
  constexpr double kClose = 0x1p-16;
  const HalfedgeId begin = graph_.outgoing(kInfinity);
  double turned = 0, last = -1, first = 0;
  const auto turnTo = [&](double turn) {
    const double step = turn < last ? turn - last + 4 : turn - last;
    if (step < 4 - kClose) turned += step;
    last = turn;
  };
  HalfedgeId h = begin;
  do {
    const VoronoiCircle& plane = circle(faceOf(h));
    if (plane.slope < kClose / 16) {
      const double turn = turnOf(plane.x, plane.y);
      if (last < 0) {
        first = last = turn;
      } else {
        turnTo(turn);
      }
    }
    h = graph_.rotateCw(h);
  } while (h != begin);
  if (last >= 0) turnTo(first);
  return turned < 6;
}

Defect DiagramCore::check() const {
  Defect defect;
  if ((defect.what = base_.check(defect.where)) != nullptr) return defect;
  if ((defect.what = hierarchy_.check(base_, defect.where, defect.level)) != nullptr) return defect;
  std::uint32_t used = 0;
  for (Slot slot = 0; slot < ids_.slots(); ++slot) {
    const auto found = [&](const char* what) { return Defect{what, ids_.idOf(slot)}; };
    if ((ids_.state(slot) == SiteState::kVisible) != base_.isVisible(vertexOf(slot))) {
      return found("the state of a site differs from its place in the graph: site");
    }
    if (ids_.state(slot) == SiteState::kFree) continue;
    ++used;
    if (ids_.slotOf(ids_.idOf(slot)) != slot) return found("the place of an id is another: site");
  }
  if (used != ids_.size()) return {"the count of sites is wrong: count", used};
  if (used != ids_.hiddenCount() + base_.visibleCount()) return {"sites are neither visible nor hidden: count", used};
  return checkHidden();
}

/// Every hidden site hangs on a site that covers it, and all of them hang, at the end, on visible ones.
Defect DiagramCore::checkHidden() const {
  FlatArray<Slot> reached;
  for (Slot slot = 0; slot < ids_.slots(); ++slot) {
    if (ids_.state(slot) == SiteState::kVisible) reached.push_back(slot);
  }
  const std::size_t visible = reached.size();
  for (std::size_t k = 0; k < reached.size(); ++k) {
    for (Slot child = hidden_.firstChild(reached[k]); child != HiddenForest::kNone; child = hidden_.nextSibling(child)) {
      const auto found = [&](const char* what) { return Defect{what, ids_.idOf(child)}; };
      if (ids_.state(child) != SiteState::kHidden) return found("a site that hangs on another is not hidden: site");
      if (!covers(site(reached[k]), site(child))) return found("a hidden site is not covered by its parent: site");
      if (reached.size() == ids_.size()) return found("the forest of hidden sites has a cycle: site");
      reached.push_back(child);
    }
  }
  if (reached.size() == visible + ids_.hiddenCount()) return {};
  return {"hidden sites hang on nothing: reached", static_cast<std::uint32_t>(reached.size())};
}

}  // namespace apollonius
