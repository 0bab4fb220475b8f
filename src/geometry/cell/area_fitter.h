// Weights for which the cells inside a region have prescribed areas.
//
// With the distance |p - c| - w, this is semi-discrete optimal transport with Euclidean cost: the
// weights are where a concave function of them is largest, whose gradient is targets less areas
// (Geiß, Klein, Penninger and Rote, "Optimally solving a transportation problem using Voronoi
// diagrams", 2012; Hartmann and Schuhmacher, "Semi-discrete optimal transport: a solution procedure
// for the unsquared Euclidean distance case", 2020). It is found by Newton's method, whose second
// derivatives are integrals along the edges (areaDerivative). What makes it converge:
//
//   - Where a step would take the weights of two neighbours nearly as far apart as their centres,
//     where one covers the other, their coupling is made stiffer and the equations are solved anew.
//     That needs no diagram. Their matrix stays positive definite, so that the step goes uphill.
//   - A step is halved until the slope of the function at its end is at most slightly negative (it
//     is concave: before its maximum the slope is positive), and no cell has nearly vanished. (As
//     all cells have an area, the second derivatives stay regular: Kitagawa, Mérigot and Thibert,
//     "Convergence of a Newton algorithm for semi-discrete optimal transport", 2019.)
//   - Around a region and in its holes cells vanish, and covers come from across. So the box of the
//     region and all sites counts too at first, a little: *regularization*, of which less and less
//     is left as areas come near their targets, and none at the end. Where an edge is in the sea
//     between islands, it counts again until the edge is on land.
//
// Equations are solved by preconditioned conjugate gradients (solve()). The fitter works on a
// diagram of its own: the caller's stays as it is.
#pragma once

#include <cstdint>
#include <span>

#include "base/flat_array.h"
#include "diagram/diagram_core.h"
#include "geometry/cell/coupling_matrix.h"
#include "geometry/curve/edge.h"
#include "geometry/window/polygon_clip.h"

namespace apollonius::internal {

/// The integral of 1 / |∇d_i - ∇d_j| along the piece of a bisector from E = e0 to e1: what the area
/// of i gains, and that of j loses, for each unit of weight that i gains. On the hyperbola
/// (A cosh μ, B sinh μ) with its foci f from the middle it is F(μ1) - F(μ0), with
///
///     F(μ) = f²/(2B) (sinh(2μ)/4 - μ/2 + μ B²/f²).
///
/// It is infinite if e1 / e0 is beyond doubles: then it is f/8 times as much at least, which is far
/// more than kLargestMagnitude, however close two sites are.
[[nodiscard]] double areaDerivative(const Bisector& bisector, double e0, double e1);

class AreaFitter {
 public:
  /// Copies the sites of a diagram, hidden ones too. Their indices 0, 1, 2, … follow the order of
  /// their slots. REQUIRES: `polygon` lives as long.
  AreaFitter(const DiagramCore& core, const NormalizedPolygon& polygon);

  [[nodiscard]] std::span<const SiteId> ids() const { return ids_; }
  /// Circles x, y, r by index, with the weights that have been reached.
  [[nodiscard]] FlatArray<double> circles() const { return circlesOf(best_); }
  /// The weight that has been reached, as a site can have it.
  [[nodiscard]] double weightOf(std::size_t index) const;

  /// Sets targets and the weights to start from, by index. Starts from equal weights if `start` is
  /// empty, or some cell is empty with it. Returns kNone, or the index of a cell that is empty with
  /// equal weights.
  static constexpr std::uint32_t kNone = 0xFFFFFFFFu;
  [[nodiscard]] std::uint32_t begin(std::span<const double> targets, std::span<const double> start);
  /// Takes a step; false if none comes closer. Throws std::bad_alloc; the same step can be taken
  /// again.
  [[nodiscard]] bool step();
  /// Has step() failed because the weights are the solution up to their last places? The errors
  /// that areas still have are rounding: of weights, and of Voronoi vertices.
  [[nodiscard]] bool isAtTheEndOfDoubles() const { return isAtTheEndOfDoubles_; }
  /// The largest deviation of an area from its target, as a share of the target.
  [[nodiscard]] double error() const { return deviationOf(best_.inside); }

 private:
  /// Weights with the areas and couplings that they give: in the region, and around it if there is
  /// a regularization.
  struct State {
    FlatArray<double> weights, inside, around;
    FlatArray<double> areas;  // inside, with their share of the regularization
    FlatArray<Coupling> couplings, couplingsAround;
  };

  [[nodiscard]] FlatArray<double> circlesOf(const State& state) const;
  void measure(State& state, VertexPrecision precision);
  void measureIn(const NormalizedPolygon& polygon, VertexPrecision precision,
                 FlatArray<double>& areas, FlatArray<Coupling>& couplings) const;
  void sumUp(State& state) const;
  void measureExactly();
  void takeTried() noexcept;
  void setRegularization(double density);
  void regularize(double density);
  [[nodiscard]] double areaApart() const;
  void findDirection(double tolerance);
  [[nodiscard]] bool tryStep(double share);
  [[nodiscard]] double longestShare() const;
  void solve(double tolerance, bool isGuess);
  [[nodiscard]] bool isWithinRounding() const;
  [[nodiscard]] double roomFor(const Coupling& coupling) const;
  [[nodiscard]] double deviationOf(std::span<const double> areas) const;
  [[nodiscard]] double slopeAt(const State& state) const;

  const NormalizedPolygon& polygon_;
  NormalizedPolygon around_;  // region and sites
  bool hasAround_ = false;    // is it larger than the region?
  DiagramCore core_;          // its ids are indices
  FlatArray<SiteId> ids_;
  FlatArray<Site> sites_;
  FlatArray<double> shares_;   // targets as shares of the region's area
  FlatArray<double> targets_;  // with their share of the regularization
  State best_, tried_;
  FlatArray<Coupling> couplings_;                        // the best state's, some of them stiffer
  FlatArray<double> direction_;                          // the next step, at full length
  double last_ = 1;                                      // share of the last step that was taken
  double regularization_ = 0;                            // its density
  VertexPrecision precision_ = VertexPrecision::kRough;  // reproducible at the end
  bool isAtTheEndOfDoubles_ = false;
};

}  // namespace apollonius::internal
