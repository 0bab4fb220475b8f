#include "geometry/areas.h"

#include "delaunay/sort_by_key.h"
#include "geometry/border.h"
#include "geometry/clip.h"
#include "geometry/measures.h"
#include "geometry/sum.h"
#include "memory/flat_array.h"

namespace apollonius::internal {

namespace {

/// A border contact of some cell, to be sorted by cell.
struct SiteContact {
  Slot site;
  BorderContact contact;
};

class AreaSum {
 public:
  AreaSum(const DiagramCore& core, const Window& window, std::vector<double>& areas)
      : core_(core), window_(window), byId_(areas), areas_(core.ids().slots()) {}

  void run() {
    const Graph& graph = core_.delaunay().graph();
    forEachClippedPiece(core_.delaunay(), window_, Bits::kCached,
                        [&](HalfedgeId h, const ClippedPiece& piece) {
                          addPiece(piece, slotOf(graph.origin(h)), slotOf(graph.target(h)));
                        });
    addBorders();
    byId_.assign(core_.ids().idLimit(), 0);
    for (Slot slot = 0; slot < areas_.size(); ++slot) {
      if (const double area = areas_[slot].value(); area > 0) byId_[core_.ids().idOf(slot)] = area;
    }
    giveWhole();
  }

 private:
  void giveWhole() {
    // If no edge meets the window, one cell has all of it. (Edges can touch it, so contacts are no
    // proof; the sum is all or nothing.)
    double sum = 0;
    for (const double area : byId_) sum += area;
    const double whole = window_.width() * window_.height();
    if (core_.visibleCount() == 0 || sum > whole / 2) return;
    if (const Slot owner = ownerOfWindow(core_, window_); owner != kNoSlot)
      byId_[core_.ids().idOf(owner)] = whole;
  }

  void addPiece(const ClippedPiece& piece, Slot left, Slot right) {
    const Conic& curve = piece.curve;
    const double beyond = areaBeyondChord(curve);
    addChord(left, curve.p0, curve.p2, beyond);
    addChord(right, curve.p2, curve.p0, -beyond);
    if (piece.fromSide != kNoSide) addContact(left, right, piece.fromSide, curve.p0, false);
    if (piece.toSide != kNoSide) addContact(left, right, piece.toSide, curve.p2, true);
  }

  void addContact(Slot left, Slot right, int side, Point point, bool leaves) {
    const double place = window_.placeOf(side, point);
    contacts_.push_back({left, {side, place, point, 0, leaves}});
    contacts_.push_back({right, {side, place, point, 0, !leaves}});
  }

  /// The triangle of a chord and the cell's origin: its centre, or the point of the window nearest
  /// to it.
  void addChord(Slot slot, Point from, Point to, double beyond) {
    const Site& site = core_.site(slot);
    const Point origin = window_.nearestTo({site.x, site.y});
    const double term = cross(from - origin, to - origin) / 2 + beyond;
    areas_[slot].add(term);
  }

  void addBorders() {
    FlatArray<Keyed> bySite(contacts_.size());
    for (std::uint32_t k = 0; k < bySite.size(); ++k) bySite[k] = {contacts_[k].site, k};
    sortByKey(bySite);
    FlatArray<BorderContact> own;
    FlatArray<BorderArc> arcs;
    for (std::size_t begin = 0; begin < bySite.size();) {
      const Slot slot = bySite[begin].key;
      own.clear();
      for (; begin < bySite.size() && bySite[begin].key == slot; ++begin)
        own.push_back(contacts_[bySite[begin].value].contact);
      matchBorder(core_, slot, window_, own, arcs);
      for (const BorderArc& arc : arcs) {
        Point at = own[arc.from].point;
        for (int k = 0; k < arc.cornerCount; ++k) {
          const Point corner = window_.corner((arc.firstCorner + k) % 4);
          addChord(slot, at, corner, 0);
          at = corner;
        }
        addChord(slot, at, own[arc.to].point, 0);
      }
    }
  }

  const DiagramCore& core_;
  Window window_;
  std::vector<double>& byId_;
  FlatArray<Sum> areas_;  // by slot
  FlatArray<SiteContact> contacts_;
};

}  // namespace

void cellAreas(const DiagramCore& core, const Window& window, std::vector<double>& areas) {
  AreaSum(core, window, areas).run();
}

}  // namespace apollonius::internal
