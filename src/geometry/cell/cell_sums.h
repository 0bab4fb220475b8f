// Sums over the boundaries of all cells, piece by piece in any order.
#pragma once

#include <vector>

#include "geometry/cell/cell_measures.h"
#include "geometry/curve/moments.h"
#include "number/sum.h"

namespace apollonius::internal {

class CellSums {
 public:
  /// REQUIRES: `box` contains all pieces. Each cell is measured about the point of the box that is
  /// nearest to its centre.
  CellSums(const DiagramCore& core, const Rectangle& box, Measure what);

  /// Adds a piece between two cells, counted `multiplicity` times for the one on its left.
  void addEdge(Slot left, Slot right, const Conic& piece, int multiplicity = 1);
  /// Adds a piece with a cell on its left, and none on its right.
  void addBorder(Slot left, const Conic& piece);

  /// The area or length in a cell, by slot.
  [[nodiscard]] double sumOf(Slot slot) const { return sums_[slot].value(); }
  /// Lists the measures by id, in the layout that Measure describes.
  void list(std::vector<double>& measures) const;

 private:
  [[nodiscard]] Point originOf(Slot slot) const {
    const Site& site = core_.site(slot);
    return box_.nearestTo({site.x, site.y});
  }
  void addPiece(Slot slot, const Conic& piece, double beyond, int multiplicity);

  const DiagramCore& core_;
  Rectangle box_;
  Measure what_;
  FlatArray<Sum> sums_;         // by slot: areas or lengths
  FlatArray<Moments> moments_;  // by slot
};

}  // namespace apollonius::internal
