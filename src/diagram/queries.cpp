#include "diagram/queries.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/flat_array.h"
#include "base/radix_sort.h"
#include "diagram/nearby_lists.h"
#include "diagram/plane.h"
#include "predicate/distance.h"
#include "topology/hull.h"

namespace apollonius::internal {

template class NearbySearch<Plane>;

namespace {

struct Rectangle {
  double xmin, ymin, xmax, ymax;
};

/// Does a site's circle meet a rectangle? The point of the rectangle closest to the centre has
/// coordinates of the two, so an exact test of that point decides.
bool meets(const Site& site, const Rectangle& r) {
  return !isBeyond(std::clamp(site.x, r.xmin, r.xmax), std::clamp(site.y, r.ymin, r.ymax), site, 0);
}

/// Replaces infinite sides of a window by the limits of all circles: seen from the middle of an
/// immense window, all sites would be at one distance, except for differences that only exact
/// arithmetic can tell. Cost: O(length of the hull). REQUIRES: not empty.
Rectangle endingWithCircles(const DiagramCore& diagram, const Rectangle& window) {
  const double far = kLargestMagnitude;
  if (window.xmin > -far && window.ymin > -far && window.xmax < far && window.ymax < far)
    return window;
  Rectangle box{far, far, -far, -far};
  const auto add = [&](const Site& site) {
    const double r = std::max(site.r, 0.0);
    const auto rounding = [&](double x) { return 8 * kUnitRoundoff * (absolute(x) + r); };
    box = {std::min(box.xmin, site.x - r - rounding(site.x)),
           std::min(box.ymin, site.y - r - rounding(site.y)),
           std::max(box.xmax, site.x + r + rounding(site.x)),
           std::max(box.ymax, site.y + r + rounding(site.y))};
  };
  const DelaunayGraph& delaunay = diagram.delaunay();
  add(delaunay.site(delaunay.anyVisible()));
  const Graph& graph = delaunay.graph();
  visitHull(graph, [&](HalfedgeId h) { add(delaunay.site(graph.origin(h))); });
  const auto inRange = [=](double x) { return std::clamp(taken(x), -far, far); };
  return {window.xmin > -far ? window.xmin : inRange(box.xmin),
          window.ymin > -far ? window.ymin : inRange(box.ymin),
          window.xmax < far ? window.xmax : inRange(box.xmax),
          window.ymax < far ? window.ymax : inRange(box.ymax)};
}

/// A coordinate that a site might have, near the middle.
double between(double low, double high) {
  const double middle = low + (high - low) / 2;
  return taken(middle);  // where it is next to 0, they are on both sides of it
}

/// Searches the window in pieces: each lists the sites around its middle up to the distance of its
/// corners, and takes those that meet the window. A piece that gets too many others is cut in two:
/// so are long windows, down to pieces as small as the sites' distances there. Where cutting does
/// not help, because the same sites are next to the border in all pieces (circles that nearly touch
/// it), more others are soon allowed.
class WindowSearch {
 public:
  WindowSearch(const DiagramCore& diagram, const Rectangle& window)
      : diagram_(diagram), window_(window) {}

  void list(std::vector<SiteId>& sites) {
    pieces_.push_back({window_, kFew});
    while (!pieces_.empty()) {
      Piece piece = pieces_.back();
      pieces_.pop_back();
      if (!isDone(piece)) cut(piece);
    }
    sortByKey(meeting_);
    sites.reserve(meeting_.size());
    for (const Keyed& entry : meeting_) sites.push_back(entry.key);
  }

 private:
  static constexpr std::size_t kFew = 16;

  struct Piece {
    Rectangle r;
    std::size_t allowed;  // how many sites may miss the window, besides twice those that meet it

    [[nodiscard]] double x() const { return between(r.xmin, r.xmax); }
    [[nodiscard]] double y() const { return between(r.ymin, r.ymax); }
    [[nodiscard]] bool isWide() const { return r.xmax - r.xmin >= r.ymax - r.ymin; }
    [[nodiscard]] bool canBeCut() const {
      return isWide() ? r.xmin < x() && x() < r.xmax : r.ymin < y() && y() < r.ymax;
    }
    /// At least the distance from the middle to each corner: five roundings.
    [[nodiscard]] double reach() const {
      const double width = std::max(x() - r.xmin, r.xmax - x());
      const double height = std::max(y() - r.ymin, r.ymax - y());
      const double length = std::sqrt(width * width + height * height) * (1 + 8 * kUnitRoundoff);
      return length == 0 ? 0 : std::max(length, kSmallestMagnitude);
    }
  };

  void cut(const Piece& piece) {
    Piece first = piece, second = piece;
    if (piece.isWide()) {
      first.r.xmax = second.r.xmin = piece.x();
    } else {
      first.r.ymax = second.r.ymin = piece.y();
    }
    pieces_.push_back(second);
    pieces_.push_back(first);
  }

  /// Adds what this piece finds, and tells whether that is all.
  [[nodiscard]] bool isDone(Piece& piece) {
    const bool isDivisible = piece.canBeCut();
    if (isDivisible && piece.reach() > kLargestMagnitude) return false;
    NearbySearch search(Plane(diagram_), {piece.x(), piece.y()},
                        std::min(piece.reach(), kLargestMagnitude));
    std::size_t meeting = 0, others = 0, known = 0;
    for (Slot slot = search.next(); slot != kNoSlot; slot = search.next()) {
      if (meets(diagram_.site(slot), window_)) {
        ++meeting;
        if (seen_.insert(slot)) meeting_.push_back({diagram_.ids().idOf(slot), slot});
        continue;
      }
      if (!seen_.insert(slot)) ++known;
      if (++others > piece.allowed + 2 * meeting && isDivisible) {
        if (2 * known > others) piece.allowed *= 4;
        return false;
      }
    }
    return true;
  }

  const DiagramCore& diagram_;
  Rectangle window_;
  FlatArray<Piece> pieces_;
  FlatArray<Keyed> meeting_;  // by their ids
  SlotSet seen_;              // also sites that do not meet the window
};

}  // namespace

Slot orNone(const DiagramCore& diagram, Slot slot, double x, double y, double maxDistance) {
  const bool isNone = slot == kNoSlot || isBeyond(x, y, diagram.site(slot), maxDistance);
  return isNone ? kNoSlot : slot;
}

void listNearest(const DiagramCore& diagram, std::span<const double> xy, double maxDistance,
                 std::span<SiteId> ids, std::span<double> distances) {
  visitPoints(diagram, xy, [&](std::size_t k, Slot hint) {
    const double x = xy[2 * k], y = xy[2 * k + 1];
    const Slot near = Plane(diagram).nearest({x, y}, hint);
    const Slot found = orNone(diagram, near, x, y, maxDistance);
    ids[k] = idOrNone(diagram, found);
    if (!distances.empty()) distances[k] = distanceTo(diagram, found, x, y);
    return near;
  });
}

void listNearby(const DiagramCore& diagram, double x, double y, std::size_t most,
                double maxDistance, std::vector<SiteId>& sites) {
  listNearby(NearbySearch(Plane(diagram), {x, y}, maxDistance), most, sites);
}

void listNearbyMany(const DiagramCore& diagram, std::span<const double> xy, std::size_t most,
                    double maxDistance, bool withDistances, NearbyLists& lists) {
  NearbyListsBuilder builder(xy.size() / 2, withDistances, lists);
  const Plane plane(diagram);
  NearbySearch search(plane);
  visitPoints(diagram, xy, [&](std::size_t k, Slot hint) {
    const Point point{xy[2 * k], xy[2 * k + 1]};
    const Slot first = plane.nearest(point, hint);
    search.start(point, maxDistance, first);
    builder.list(k, search, most);
    return first;
  });
  builder.finish();
}

Slot farthestSite(const DiagramCore& diagram, double x, double y) {
  const DelaunayGraph& delaunay = diagram.delaunay();
  if (delaunay.visibleCount() == 0) return kNoSlot;
  Slot best = slotOf(delaunay.anyVisible());
  visitHull(delaunay.graph(), [&](HalfedgeId h) {
    const Slot slot = slotOf(delaunay.graph().origin(h));
    const Site &a = diagram.site(slot), &b = diagram.site(best);
    const Sign farther = compareDistance(x, y, opposite(a), opposite(b));
    if (farther == Sign::kPositive || (farther == Sign::kZero && precedes(b, a))) best = slot;
  });
  return best;
}

void listMeeting(const DiagramCore& diagram, double xmin, double ymin, double xmax, double ymax,
                 std::vector<SiteId>& sites) {
  sites.clear();
  if (diagram.visibleCount() == 0) return;
  const Rectangle window = endingWithCircles(diagram, {xmin, ymin, xmax, ymax});
  if (window.xmin > window.xmax || window.ymin > window.ymax) return;
  WindowSearch(diagram, window).list(sites);
}

}  // namespace apollonius::internal
