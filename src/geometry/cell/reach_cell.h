// The part of a clipped cell within a distance of its site's circle: cells that grow until they
// meet, and stop where they have come far enough. The circle about the site's centre that bounds it
// cuts the rings of the cell; inside, they are joined by arcs.
//
// Exits, where the rings leave the circle, and entries, where they come back, alternate around it.
// Each kind is sorted by itself. The k-th exit belongs to the k-th entry if the circle is outside
// of the cell at the direction where counting begins, and to the next one if it is inside. So
// rounding can swap an exit and an entry that are very close, but not lose one.
#pragma once

#include <memory>

#include "apollonius/reach.h"
#include "diagram/diagram_core.h"
#include "geometry/cell/cell_clipper.h"
#include "geometry/cell/reach_edge.h"
#include "geometry/cell/ring_sorter.h"

namespace apollonius::internal {

class ReachCellClipper final : public CellClipper {
 public:
  /// REQUIRES: `core` and `reach` live as long.
  ReachCellClipper(const DiagramCore& core, const Reach& reach, std::unique_ptr<CellClipper> cells)
      : CellClipper(cells->parts()),
        core_(core),
        reach_(reach),
        cells_(std::move(cells)),
        rings_(parts()) {}

  /// A piece with nothing on its right is isAtReach; then arcs have no neighbor, and a piece of an
  /// edge has the one whose reach does not go so far. Cost: that of the whole cell, and O(c log c)
  /// for c points where the circle cuts it.
  const Cell& find(Slot site) override;
  void expectAll() override { cells_->expectAll(); }
  [[nodiscard]] double radiusOf(SiteId site) const override {
    return core_.site(core_.ids().slotOf(site)).r + reach_.of(site);
  }

 private:
  struct Piece {
    BoundaryPiece piece;
    bool isFromCut, isToCut;
    std::uint32_t source;           // the piece of the ring that it is a part of
    std::uint32_t next = kNoPiece;  // the piece that begins where it ends
  };
  static constexpr std::uint32_t kNoPiece = 0xFFFFFFFFu;
  /// A point where a ring leaves the circle, or comes back to it.
  struct Passage {
    Point direction;  // from the centre
    std::uint32_t piece;
    double turn = 0;  // pseudo-angle from where counting begins
  };

  void cutRing(std::span<const BoundaryPiece> ring);
  void cutEdge(const BoundaryPiece& piece, std::uint32_t source);
  void cutBorder(const BoundaryPiece& piece, std::uint32_t source);
  [[nodiscard]] bool isInside(const Cell& whole, double from, double width) const;
  static void sortByTurn(Point start, FlatArray<Passage>& passages);
  void sortPassages(const Cell& whole);
  void trace();
  void addArc(const Passage& exit, const Passage& entry, double turn);

  const DiagramCore& core_;
  const Reach& reach_;
  std::unique_ptr<CellClipper> cells_;
  RingSorter rings_;
  Cell cell_;
  Site site_{};
  ReachOfSite own_{};
  Point center_;
  FlatArray<Piece> pieces_;
  FlatArray<Passage> exits_, entries_;
  std::uint32_t shift_ = 0;          // index of an exit's entry less that of the exit
  FlatArray<std::uint32_t> exitOf_;  // by piece: index in exits_
  FlatArray<char> isUsed_;           // by piece
};

}  // namespace apollonius::internal
