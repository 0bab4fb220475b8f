// The cell of a site inside the window, as closed boundaries of conic pieces: counter-clockwise,
// and clockwise around the holes that only windows of other shapes than rectangles make.
//
// A cell is star-shaped about its site's centre (on the way there no other site's distance falls
// faster) and so in one piece, without holes; the window is convex, so a clipped cell is any number
// of parts, each without holes, that meet the window's border.
#pragma once

#include <cstdint>

#include "base/flat_array.h"
#include "diagram/diagram_core.h"
#include "geometry/cell/cell_clipper.h"
#include "geometry/window/rectangle_border.h"
#include "geometry/window/rectangle_clip.h"

namespace apollonius::internal {

class RectangleCellClipper final : public CellClipper {
 public:
  RectangleCellClipper(const DiagramCore& core, const Rectangle& window, Parts parts)
      : CellClipper(parts), core_(core), window_(window) {}

  /// Cost: O(d log d).
  const Cell& find(Slot site) override;
  void expectAll() override {
    kept_.resize(kMostKept);
    vertices_.resize(kMostKept);
  }

 private:
  struct Piece {
    ClippedPiece clipped;
    SiteId neighbor;
  };

  /// The clipped edge of a half-edge, if it is one piece.
  struct KeptEdge {
    ClippedPiece piece;
    HalfedgeId halfedge{0xFFFFFFFFu};
  };
  static constexpr std::size_t kMostKept = 4096;  // 300 KB, and 130 KB of vertices

  void clipEdges(Slot site);
  /// REQUIRES: startsAtReference.
  void clip(HalfedgeId h, ClippedEdge& clipped);
  void link(Slot site);
  void wholeWindow();
  void addBorder(const BorderArc& arc);
  /// Ends a part; takes it back if its area is 0 up to rounding, as when a cell only touches the
  /// window.
  void closePart();

  const DiagramCore& core_;
  Rectangle window_;
  Cell cell_;
  FlatArray<KeptEdge> kept_;  // by half-edge modulo kMostKept: the last one
  KeptVertices vertices_;
  FlatArray<Piece> pieces_;
  FlatArray<BorderContact> contacts_;
  FlatArray<BorderArc> arcs_;
  FlatArray<std::uint32_t> arcAfter_;  // by piece: the border arc that follows it
  FlatArray<char> isUsed_;             // by piece
};

}  // namespace apollonius::internal
