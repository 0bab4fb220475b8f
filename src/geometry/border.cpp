#include "geometry/border.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "memory/flat_array.h"

namespace apollonius::internal {

namespace {

/// Places from a reference on: 0 to 4.
double after(double place, double reference) {
  const double d = place - reference;
  return d >= 0 ? d : d + 4;
}

/// Before, counter-clockwise from corner 0. Places are rounded to a share of the side, coordinates
/// are not. Which is first of several in one point, as far as doubles can tell, their numbers say:
/// CellFinder counts pieces from one edge on after any history, and sums do not ask which it is.
bool comesBefore(const BorderContact& a, const BorderContact& b) {
  if (a.place != b.place) return a.place < b.place;
  if (a.side != b.side) return a.side < b.side;
  const auto along = [](const BorderContact& c) {
    return c.side == 0   ? c.point.x
           : c.side == 1 ? c.point.y
           : c.side == 2 ? -c.point.x
                         : -c.point.y;
  };
  if (along(a) != along(b)) return along(a) < along(b);
  return a.leaves != b.leaves ? a.leaves : a.piece < b.piece;
}

/// The number of corners on the way between two contacts, of which rounded places count `seen`. One
/// at each end may be missing there, none is too many; and none is on the way if rounding has
/// exchanged the two.
int cornersBetween(const BorderContact& from, const BorderContact& to, int seen) {
  int count = (to.side - from.side + 4) % 4;
  while (count < seen) count += 4;
  if (count - seen > 2) count -= 4;
  return std::clamp(count, 0, 4);
}

/// Disorder of two sorted lists that should alternate, one[0] first: the sum of what they overlap.
double disorder(const FlatArray<double>& one, const FlatArray<double>& two) {
  double sum = 0;
  for (std::size_t k = 0; k < one.size(); ++k) {
    sum += std::max(0.0, one[k] - two[k]);
    if (k + 1 < one.size()) sum += std::max(0.0, two[k] - one[k + 1]);
  }
  return sum;
}

/// Coordinates whose magnitude is below the documented range, which means nothing but rounding,
/// become 0.
double inRange(double x) { return absolute(x) < kSmallestMagnitude ? 0 : x; }

Slot nearest(const DiagramCore& core, Point p) { return core.nearest(inRange(p.x), inRange(p.y)); }

/// Does the site own the border around the middle of a gap between contacts? Asked inside of the
/// window, because the border itself may be an edge of the diagram: one double inside, or farther
/// than an edge along the border can be rounded. And at five places, because any one may be too
/// close to an edge.
bool ownsGap(const DiagramCore& core, Slot site, const Window& window, double middlePlace,
             double gap, bool isBarelyInside) {
  const Point center = window.center();
  int votes = 0;
  for (const double part : {0.0, -0.21, 0.17, -0.34, 0.38}) {
    double place = middlePlace + part * gap;
    place += place < 0 ? 4 : place >= 4 ? -4 : 0;
    const Point p = window.at(place);
    const Point inside = isBarelyInside
                             ? Point{std::nextafter(p.x, center.x), std::nextafter(p.y, center.y)}
                             : p + powerOfTwo(-20) * (center - p);
    votes += nearest(core, inside) == site ? 1 : -1;
  }
  return votes > 0;
}

/// Of contacts that are all in pairs, so that the site owns next to nothing of the border or all
/// but that: does it own the middle of the largest gap, before the first contact? What is behind an
/// edge along the border, nearer to it than the edge is rounded, owns it barely inside only; so
/// does a cell along the border that is as thin as that, in a window many times as wide. Of the
/// latter the contacts know: the first one tells.
bool ownsLargestGap(const DiagramCore& core, Slot site, const Window& window,
                    const BorderContact& first, double middlePlace, double gap) {
  const bool owns = ownsGap(core, site, window, middlePlace, gap, false);
  return owns == ownsGap(core, site, window, middlePlace, gap, true) ? owns : !first.leaves;
}

/// Two ways of matching whose disorders differ by less than this, in sides, are taken for equally
/// good. Rounding of the curves moves a crossing that is not tangent by far less than 2^-24, and a
/// tangent one by its root, 2^-26 at most. Vertices are rounded to doubles, besides, which is more
/// than that in a window of few doubles: one of their distances.
double noDifference(const Window& window) {
  const double largest = std::max(
      {absolute(window.xmin), absolute(window.ymin), absolute(window.xmax), absolute(window.ymax)});
  return powerOfTwo(-24) + powerOfTwo(-52) * largest / std::min(window.width(), window.height());
}

}  // namespace

Slot ownerOfWindow(const DiagramCore& core, const Window& window) {
  // A sliver of a cell, lost to rounding, can own the middle; but hardly the corners, too, which
  // are asked just inside.
  const Slot middle = nearest(core, window.center());
  int votes = 1;
  for (int k = 0; k < 4; ++k) {
    const Point corner = window.corner(k);
    votes += nearest(core, corner + powerOfTwo(-20) * (window.center() - corner)) == middle ? 1 : 0;
  }
  return votes >= 3 ? middle : kNoSlot;
}

void matchBorder(const DiagramCore& core, Slot site, const Window& window,
                 FlatArray<BorderContact>& contacts, FlatArray<BorderArc>& arcs) {
  arcs.clear();
  // Edges that are none (trusted snapshots may lie) leave the border nowhere.
  const auto isOnBorder = [](const BorderContact& c) { return c.place >= 0 && c.place <= 4; };
  if (contacts.empty() || !std::all_of(contacts.begin(), contacts.end(), isOnBorder)) return;
  // All of them: a heap sort, which is a tenth of std::sort's code.
  std::partial_sort(contacts.begin(), contacts.end(), contacts.end(), comesBefore);
  // The reference is the middle of the largest gap.
  double reference = 0, gap = -1;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const double next = k + 1 < contacts.size() ? contacts[k + 1].place : contacts[0].place + 4;
    if (next - contacts[k].place > gap) {
      gap = next - contacts[k].place;
      reference = contacts[k].place + gap / 2;
    }
  }
  if (reference >= 4) reference -= 4;
  std::rotate(contacts.begin(),
              std::find_if(contacts.begin(), contacts.end(),
                           [&](const BorderContact& c) { return c.place > reference; }),
              contacts.end());

  FlatArray<std::uint32_t> leaves, enters;
  FlatArray<double> leavePlaces, enterPlaces;
  for (std::uint32_t k = 0; k < contacts.size(); ++k) {
    const bool isLeave = contacts[k].leaves;
    (isLeave ? leaves : enters).push_back(k);
    (isLeave ? leavePlaces : enterPlaces).push_back(after(contacts[k].place, reference));
  }
  const std::size_t count =
      std::min(leaves.size(), enters.size());  // they are equally many, if the edges are some
  if (count == 0) return;
  leavePlaces.resize(count);
  enterPlaces.resize(count);
  const double outside = disorder(leavePlaces, enterPlaces),
               inside = disorder(enterPlaces, leavePlaces);
  const bool isClear = absolute(outside - inside) > noDifference(window);
  const bool holdsReference =
      isClear ? inside < outside : ownsLargestGap(core, site, window, contacts[0], reference, gap);

  for (std::size_t k = 0; k < count; ++k) {
    const bool isWrapped = holdsReference && k + 1 == count;
    const std::size_t m = holdsReference ? (k + 1) % count : k;
    BorderArc arc{leaves[k], enters[m]};
    const double from = leavePlaces[k], to = enterPlaces[m] + (isWrapped ? 4 : 0);
    int seen = 0;
    for (int step = 0; step < 8; ++step) {  // corners once around from the reference, and once more
      const double at = static_cast<int>(reference) + 1 - reference + step;
      seen += at > from && at < to;
    }
    arc.firstCorner = (contacts[arc.from].side + 1) % 4;
    arc.cornerCount = cornersBetween(contacts[arc.from], contacts[arc.to], seen);
    arcs.push_back(arc);
  }
}

}  // namespace apollonius::internal
