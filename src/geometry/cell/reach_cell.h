// The part of a clipped cell within a distance of its site's circle: cells that grow until they
// meet, and stop where they have come far enough. The circle about the site's centre that bounds it
// cuts the rings of the cell; inside, they are joined by arcs.
//
// Where the rings leave the circle and where they come back alternates around it. So both are
// sorted by themselves, and the k-th exit belongs to the k-th entry or to the next one, as the
// circle is outside of the cell or inside at the direction where counting begins: rounding can
// exchange an exit and an entry that are as close as that, but not lose one.
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

  /// Pieces beyond which nothing is are isAtReach; arcs have no neighbor, pieces of edges have that
  /// whose reach does not go so far. Cost: that of the whole cell, and O(c log c) for c places
  /// where the circle cuts it.
  const Cell& find(Slot site) override;
  void expectAll() override { cells_->expectAll(); }
  [[nodiscard]] double radiusOf(SiteId site) const override {
    return core_.site(core_.ids().slotOf(site)).r + reach_.of(site);
  }

 private:
  struct Piece {
    BoundaryPiece piece;
    bool isFromCut, isToCut;
    std::uint32_t source;           // the piece of the ring that it is of
    std::uint32_t next = kNoPiece;  // that begins where it ends
  };
  static constexpr std::uint32_t kNoPiece = 0xFFFFFFFFu;
  /// Where a ring leaves the circle, or comes back to it.
  struct Passage {
    Point direction;  // from the centre
    std::uint32_t piece;
    double turn = 0;  // to it, from where counting begins
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
  std::uint32_t shift_ = 0;          // from an exit to its entry, in their orders
  FlatArray<std::uint32_t> exitOf_;  // by piece: of exits_
  FlatArray<char> isUsed_;           // by piece
};

}  // namespace apollonius::internal
