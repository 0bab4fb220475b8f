#include "geometry/window/rectangle_border.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "apollonius/types.h"
#include "base/flat_array.h"

namespace apollonius::internal {

namespace {

/// Position relative to a reference: 0 to 4.
double after(double position, double reference) {
  const double d = position - reference;
  return d >= 0 ? d : d + 4;
}

/// Does a come before b, counter-clockwise from corner 0? Positions are rounded, coordinates are
/// not. Ties at one point are broken by piece number: RectangleCellClipper numbers pieces from the
/// same edge on after any history, and for sums the order does not matter.
bool comesBefore(const BorderContact& a, const BorderContact& b) {
  if (a.position != b.position) return a.position < b.position;
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

/// The number of corners on the way between two contacts. `seen` is the number by rounded
/// positions: it may miss one corner at each end, and never counts too many. No corner is on the
/// way if rounding has swapped the two.
int cornersBetween(const BorderContact& from, const BorderContact& to, int seen) {
  int count = (to.side - from.side + 4) % 4;
  while (count < seen) count += 4;
  if (count - seen > 2) count -= 4;
  return std::clamp(count, 0, 4);
}

/// Disorder of two sorted lists that should alternate, one[0] first: the sum of their overlaps.
double disorder(const FlatArray<double>& one, const FlatArray<double>& two) {
  double sum = 0;
  for (std::size_t k = 0; k < one.size(); ++k) {
    sum += std::max(0.0, one[k] - two[k]);
    if (k + 1 < one.size()) sum += std::max(0.0, two[k] - one[k + 1]);
  }
  return sum;
}

Slot nearest(const DiagramCore& core, Point p) { return core.nearest(taken(p.x), taken(p.y)); }

/// Does the site own the gap before the first contact? `isTold` is the contacts' answer, `isSure`
/// whether it is certain. In a window many times as large as what is in it, rounding moves contacts
/// along whole sides, and their answer can be wrong. So all gaps are tested, at one point each; and
/// if one contradicts, or the answer is not certain, at five points each, because any one may be
/// too close to an edge: the answer is what is right along most of the border. The points are on
/// the border itself, as a cell along it may be thinner than doubles can tell. Where the border
/// lies on an edge, the tie rule of nearest() picks the owner; so one site loses at most two of a
/// window's four sides.
bool ownsFirstGap(const DiagramCore& core, Slot site, const Rectangle& window,
                  const FlatArray<BorderContact>& contacts, double reference, bool isTold,
                  bool isSure) {
  double balance = 0;
  for (const double part : {0.5, 0.29, 0.67, 0.16, 0.88}) {
    // How often the site owns a gap if it does not own the first: 0, 1, or another number by
    // rounding.
    int multiplicity = 0;
    double begin = after(contacts.back().position, reference) - 4;
    for (const BorderContact& contact : contacts) {
      const double end = after(contact.position, reference);
      const double position = reference + begin + part * (end - begin);
      const bool owns = nearest(core, window.at(position - 4 * std::floor(position / 4))) == site;
      balance += multiplicity >= (owns ? 1 : 0) ? begin - end : end - begin;
      isSure = isSure && owns == (multiplicity + (isTold ? 1 : 0) > 0);
      multiplicity += contact.leaves ? 1 : -1;
      begin = end;
    }
    if (isSure) return isTold;
  }
  return balance == 0 ? isTold : balance > 0;
}

}  // namespace

Slot ownerOfWindow(const DiagramCore& core, const Rectangle& window) {
  // A sliver of a cell, lost to rounding, can own the middle, but hardly the corners, too. These
  // are tested just inside.
  const Slot middle = nearest(core, window.center());
  int votes = 1;
  for (int k = 0; k < 4; ++k) {
    const Point corner = window.corner(k);
    votes += nearest(core, corner + powerOfTwo(-20) * (window.center() - corner)) == middle ? 1 : 0;
  }
  return votes >= 3 ? middle : kNoSlot;
}

void linkBorderArcs(const DiagramCore& core, Slot site, const Rectangle& window,
                    FlatArray<BorderContact>& contacts, FlatArray<BorderArc>& arcs) {
  arcs.clear();
  // Invalid edges, which a trusted snapshot can have, give positions outside of the border.
  const auto isOnBorder = [](const BorderContact& c) { return c.position >= 0 && c.position <= 4; };
  if (contacts.empty() || !std::all_of(contacts.begin(), contacts.end(), isOnBorder)) return;
  // Sorts all: a heap sort, which has a tenth of std::sort's code.
  std::partial_sort(contacts.begin(), contacts.end(), contacts.end(), comesBefore);
  // The reference is the middle of the largest gap.
  double reference = 0, gap = -1;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const double next =
        k + 1 < contacts.size() ? contacts[k + 1].position : contacts[0].position + 4;
    if (next - contacts[k].position > gap) {
      gap = next - contacts[k].position;
      reference = contacts[k].position + gap / 2;
    }
  }
  if (reference >= 4) reference -= 4;
  std::rotate(contacts.begin(),
              std::find_if(contacts.begin(), contacts.end(),
                           [&](const BorderContact& c) { return c.position > reference; }),
              contacts.end());

  FlatArray<std::uint32_t> leaves, enters;
  FlatArray<double> leavePositions, enterPositions;
  for (std::uint32_t k = 0; k < contacts.size(); ++k) {
    const bool isLeave = contacts[k].leaves;
    (isLeave ? leaves : enters).push_back(k);
    (isLeave ? leavePositions : enterPositions).push_back(after(contacts[k].position, reference));
  }
  const std::size_t count =
      std::min(leaves.size(), enters.size());  // equal, unless edges are invalid
  if (count == 0) return;
  leavePositions.resize(count);
  enterPositions.resize(count);
  const double outside = disorder(leavePositions, enterPositions),
               inside = disorder(enterPositions, leavePositions);
  const bool holdsReference =
      ownsFirstGap(core, site, window, contacts, reference, inside < outside, inside != outside);

  for (std::size_t k = 0; k < count; ++k) {
    const bool isWrapped = holdsReference && k + 1 == count;
    const std::size_t m = holdsReference ? (k + 1) % count : k;
    BorderArc arc{leaves[k], enters[m]};
    const double from = leavePositions[k], to = enterPositions[m] + (isWrapped ? 4 : 0);
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
