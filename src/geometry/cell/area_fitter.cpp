#include "geometry/cell/area_fitter.h"

#include <algorithm>
#include <limits>

#include "apollonius/types.h"
#include "diagram/bulk_insertion.h"
#include "geometry/cell/cell_measures.h"
#include "geometry/cell/cell_sums.h"

namespace apollonius::internal {

namespace {

/// Total regularization at first, as a share of the region's area.
constexpr double kFirstGround = 1e-4;
/// Factor by which it falls while the areas are within kNearEnough of their targets. It is dropped
/// when its total is less than kLeastGround of the smallest target.
constexpr double kNextGround = 0.1;
constexpr double kNearEnough = 0.3;
constexpr double kLeastGround = 1e-3;
/// The surroundings of a region are ignored if they are less than this share of it.
constexpr double kLeastOutside = 1e-3;
/// Largest share of the way to where one site covers another that a step takes.
constexpr double kShareOfWay = 0.9;
/// A direction that takes more than this share of it makes the coupling stiffer, by
/// kMoreThanEnough times what would suffice.
constexpr double kShareOfRoom = 0.7;
constexpr double kMoreThanEnough = 1.5;
constexpr int kStiffenings = 3;
/// A cell has nearly vanished when it is this share of what it was or should be.
constexpr double kVanished = 1e-4;
/// Relative tolerance of the linear solve: loose far away, tight near the end.
constexpr double kCoarse = 0.01;
constexpr double kMedium = 1e-4;
constexpr double kFine = 1e-7;
constexpr int kMostHalvings = 30;
/// Sums of areas that should be equal differ by less than this share of the whole.
constexpr double kRounding = 1e-12;
/// Two units in the last place of a double, as a share of it.
constexpr double kLastPlaces = powerOfTwo(-51);

/// Natural logarithm of a finite r >= 1, with + - * / and roots only: takes roots until r is near
/// 1, then sums up 2 artanh((r-1)/(r+1)).
double logarithm(double r) {
  double scale = 2;
  for (; r > 1.5; scale *= 2) r = std::sqrt(r);
  const double z = (r - 1) / (r + 1), square = z * z;  // at most 0.2
  double sum = 0;
  for (int k = 23; k > 0; k -= 2) sum = sum * square + 1.0 / k;
  return scale * z * sum;
}

double sumOf(std::span<const double> values) {
  Sum sum;
  for (const double value : values) sum.add(value);
  return sum.value();
}

double smallestOf(std::span<const double> values) {
  return *std::min_element(values.begin(), values.end());
}

void scaleTo(FlatArray<double>& values, double whole) {
  const double factor = whole / sumOf(values);
  for (double& value : values) value *= factor;
}

double product(std::span<const double> a, std::span<const double> b) {
  double sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += a[k] * b[k];
  return sum;
}

}  // namespace

double areaDerivative(const Bisector& bisector, double e0, double e1) {
  if (!(e1 > e0)) return 0;
  const double f = bisector.distance() / 2, b = bisector.conjugate();
  // sinh 2μ1 - sinh 2μ0 = 2 cosh(μ1 + μ0) sinh(μ1 - μ0).
  const double ratio = e1 / e0, product = e0 * e1;
  if (ratio > std::numeric_limits<double>::max()) return ratio;
  const double way = logarithm(ratio);
  const double wave = (product + 1 / product) / 2 * ((ratio - 1 / ratio) / 2);
  return f * f / (4 * b) * (wave - way) + b / 2 * way;
}

AreaFitter::AreaFitter(const DiagramCore& core, const NormalizedPolygon& polygon)
    : polygon_(polygon), core_(core.location()) {
  for (Slot slot = 0; slot < core.ids().slots(); ++slot) {
    if (core.ids().state(slot) == SiteState::kFree) continue;
    ids_.push_back(core.ids().idOf(slot));
    sites_.push_back(core.site(slot));
  }
}

double AreaFitter::weightOf(std::size_t index) const { return taken(best_.weights[index]); }

std::uint32_t AreaFitter::begin(std::span<const double> targets, std::span<const double> start) {
  const std::size_t count = sites_.size();
  if (count == 0) return kNone;
  shares_.assign(targets);
  scaleTo(shares_, 1);
  best_.weights.resize(count);
  for (std::size_t k = 0; k < count; ++k) best_.weights[k] = sites_[k].r;
  const double mean = sumOf(best_.weights) / static_cast<double>(count);
  if (start.empty()) {
    best_.weights.assign(count, mean);
  } else {
    best_.weights.assign(start);
  }
  FlatArray<SiteId> ids(count);
  insertAll(core_, circlesOf(best_), ids);
  measure(best_, precision_);
  if (!start.empty() && !(smallestOf(best_.inside) > 0)) {
    best_.weights.assign(count, mean);
    measure(best_, precision_);
  }
  setRegularization(0);
  const double* const empty = std::min_element(best_.areas.begin(), best_.areas.end());
  if (!(*empty > 0)) return static_cast<std::uint32_t>(empty - best_.areas.begin());
  Rectangle around = polygon_.box;
  for (const Site& site : sites_) {
    around.xmin = std::min(around.xmin, site.x);
    around.ymin = std::min(around.ymin, site.y);
    around.xmax = std::max(around.xmax, site.x);
    around.ymax = std::max(around.ymax, site.y);
  }
  const double inside = sumOf(best_.areas), all = around.width() * around.height();
  hasAround_ = all - inside > kLeastOutside * inside;
  if (hasAround_) {
    const double corners[] = {around.xmin, around.ymin, around.xmax, around.ymin,
                              around.xmax, around.ymax, around.xmin, around.ymax};
    const std::uint32_t starts[] = {0, 4};
    around_ = normalizePolygon(corners, starts);
    if (error() > kNearEnough) regularize(kFirstGround * (inside / all));
  }
  if (error() < kCoarse) measureExactly();
  return kNone;
}

/// Circles x, y, r by index.
FlatArray<double> AreaFitter::circlesOf(const State& state) const {
  FlatArray<double> xyr;
  for (std::size_t k = 0; k < sites_.size(); ++k) {
    for (const double number : {sites_[k].x, sites_[k].y, taken(state.weights[k])})
      xyr.push_back(number);
  }
  return xyr;
}

/// Area that has to go from one part of the region to another, where no edge between cells connects
/// the parts: there, weights can change while all areas stay.
double AreaFitter::areaApart() const {
  const std::size_t count = sites_.size();
  FlatArray<std::uint32_t> parts(count);
  for (std::uint32_t k = 0; k < count; ++k) parts[k] = k;
  const auto partOf = [&](std::uint32_t k) {
    while (parts[k] != k) k = parts[k] = parts[parts[k]];
    return k;
  };
  for (const Coupling& c : best_.couplings) parts[partOf(c.i)] = partOf(c.j);
  const double whole = sumOf(best_.inside);
  FlatArray<double> missing(count, 0);
  for (std::uint32_t k = 0; k < count; ++k)
    missing[partOf(k)] += whole * shares_[k] - best_.inside[k];
  double most = 0;
  for (const double area : missing) most = std::max(most, absolute(area));
  return most > kRounding * whole ? most : 0;
}

/// Sets the density of the regularization from now on.
void AreaFitter::setRegularization(double density) {
  regularization_ = density;
  sumUp(best_);
  targets_ = shares_;
  scaleTo(targets_, sumOf(best_.areas));
}

/// Begins a regularization of this density where there was none. The diagram has the best weights
/// then: a step that failed and left others had already called this if it was needed.
void AreaFitter::regularize(double density) {
  measureIn(around_, precision_, best_.around, best_.couplingsAround);
  setRegularization(density);
}

/// Measures the best weights again, with reproducible vertices, as all that are tried from now on.
void AreaFitter::measureExactly() {
  tried_.weights = best_.weights;
  measure(tried_, VertexPrecision::kReproducible);
  takeTried();
  precision_ = VertexPrecision::kReproducible;
  setRegularization(regularization_);
}

void AreaFitter::takeTried() noexcept { std::swap(best_, tried_); }

/// Computes the areas and couplings that the weights of a state lead to.
void AreaFitter::measure(State& state, VertexPrecision precision) {
  const std::size_t count = sites_.size();
  FlatArray<SiteId> ids(count);
  for (std::uint32_t k = 0; k < count; ++k) ids[k] = k;
  core_.updateMany(ids, circlesOf(state));
  measureIn(polygon_, precision, state.inside, state.couplings);
  state.around.clear();
  state.couplingsAround.clear();
  if (regularization_ > 0) measureIn(around_, precision, state.around, state.couplingsAround);
  sumUp(state);
}

/// Sets the areas of a state: those inside, and their share of the regularization.
void AreaFitter::sumUp(State& state) const {
  state.areas.resize(state.inside.size());
  for (std::size_t k = 0; k < state.areas.size(); ++k)
    state.areas[k] =
        state.inside[k] + (regularization_ > 0 ? regularization_ * state.around[k] : 0);
}

/// Computes areas and couplings in a region, for the weights that the diagram has.
void AreaFitter::measureIn(const NormalizedPolygon& polygon, VertexPrecision precision,
                           FlatArray<double>& areas, FlatArray<Coupling>& couplings) const {
  const ClippedDiagram clippedDiagram(core_, polygon);
  CellSums sums(core_, polygon.box, Measure::kAreas);
  const Graph& graph = core_.delaunay().graph();
  couplings.clear();
  clippedDiagram.visitEdges(
      precision, [&](HalfedgeId h, const Edge& edge, const InsideInterval& piece) {
        const VertexId i = graph.origin(h), j = graph.target(h);
        sums.addEdge(slotOf(i), slotOf(j), piece.curve, piece.multiplicity);
        const double derivative =
            piece.multiplicity * areaDerivative(edge.bisector, piece.e0, piece.e1);
        if (derivative > 0 && derivative < kLargestMagnitude)
          couplings.push_back({core_.siteOf(i), core_.siteOf(j), derivative});
      });
  addBorders(clippedDiagram, sums);
  areas.assign(sites_.size(), 0);
  for (Slot slot = 0; slot < core_.ids().slots(); ++slot)
    areas[core_.ids().idOf(slot)] = sums.sumOf(slot);
}

double AreaFitter::deviationOf(std::span<const double> areas) const {
  const double whole = sumOf(areas);
  double largest = 0;
  for (std::size_t k = 0; k < areas.size(); ++k) {
    const double target = whole * shares_[k];
    largest = std::max(largest, absolute(areas[k] - target) / target);
  }
  return largest;
}

/// How far the difference of two weights can still change, in the sense in which the direction
/// changes it, until one site covers the other.
double AreaFitter::roomFor(const Coupling& c) const {
  const double apart = length({sites_[c.i].x - sites_[c.j].x, sites_[c.i].y - sites_[c.j].y});
  const double difference = best_.weights[c.i] - best_.weights[c.j];
  return direction_[c.i] > direction_[c.j] ? apart - difference : apart + difference;
}

/// Slope of the concave function at a state, along the direction.
double AreaFitter::slopeAt(const State& state) const {
  double slope = 0;
  for (std::size_t k = 0; k < targets_.size(); ++k)
    slope += (targets_[k] - state.areas[k]) * direction_[k];
  return slope;
}

bool AreaFitter::step() {
  if (sites_.empty()) return false;
  const double all = around_.box.width() * around_.box.height();
  const double apart = hasAround_ ? areaApart() : 0;
  // The total regularization is less than the area that has to go to another part: so the edge
  // between them crosses the gap.
  if (apart > 0 && regularization_ == 0) regularize(kNextGround * apart / all);
  double far = deviationOf(best_.areas);
  for (; regularization_ > 0 && far < kNearEnough && apart == 0; far = deviationOf(best_.areas)) {
    const double less = kNextGround * regularization_;
    setRegularization(less * all < kLeastGround * smallestOf(targets_) ? 0 : less);
  }
  // Once steps are short, each must be accurate for small cells, too.
  findDirection(far < kCoarse ? kFine : last_ < 0.25 ? kMedium : kCoarse);
  const bool isLast = regularization_ == 0 && isWithinRounding();
  // The areas may have the errors of cached vertices.
  if (isLast && precision_ == VertexPrecision::kRough) {
    measureExactly();
    return true;
  }
  const double before = error();
  double share = longestShare();
  for (int halvings = 0; halvings < kMostHalvings; ++halvings, share /= 2) {
    // The function is concave: where its slope is only slightly negative, the maximum is near.
    if (!tryStep(share) || !(slopeAt(tried_) >= -slopeAt(best_) / 2)) continue;
    // Near the end, cached vertices are not accurate enough for the areas of small cells.
    if (precision_ == VertexPrecision::kRough && deviationOf(tried_.inside) < kCoarse) {
      measure(tried_, VertexPrecision::kReproducible);
      precision_ = VertexPrecision::kReproducible;
    }
    takeTried();
    last_ = share;
    if (!isLast || error() < before) return true;
    takeTried();  // back
    break;
  }
  isAtTheEndOfDoubles_ = isLast;
  return false;
}

/// Does the direction change only the last places: of weights, or of the coordinates that vertices
/// are computed from?
bool AreaFitter::isWithinRounding() const {
  for (std::size_t k = 0; k < direction_.size(); ++k) {
    const Site& site = sites_[k];
    const double size = std::max({absolute(best_.weights[k]), absolute(site.x), absolute(site.y)});
    if (absolute(direction_[k]) > kLastPlaces * size) return false;
  }
  return true;
}

/// Tries this share of the step; false if a weight leaves the range, or a cell nearly vanishes.
bool AreaFitter::tryStep(double share) {
  tried_.weights.resize(direction_.size());
  for (std::size_t k = 0; k < direction_.size(); ++k) {
    tried_.weights[k] = best_.weights[k] + share * direction_[k];
    if (!(absolute(tried_.weights[k]) <= kLargestMagnitude)) return false;
  }
  measure(tried_, precision_);
  for (std::size_t k = 0; k < targets_.size(); ++k) {
    if (!(tried_.areas[k] >= kVanished * std::min(best_.areas[k], targets_[k]))) return false;
  }
  return true;
}

/// The largest share of the direction that may be taken.
double AreaFitter::longestShare() const {
  double share = 1;
  for (const Coupling& c : couplings_) {
    const double change = absolute(direction_[c.i] - direction_[c.j]);
    if (share * change > kShareOfWay * roomFor(c)) share = kShareOfWay * roomFor(c) / change;
  }
  return share;
}

/// Computes Newton's direction, and stiffens couplings until it has room.
void AreaFitter::findDirection(double tolerance) {
  couplings_ = best_.couplings;
  if (regularization_ > 0) {
    for (const Coupling& c : best_.couplingsAround)
      couplings_.push_back({c.i, c.j, regularization_ * c.derivative});
  }
  solve(tolerance, false);
  for (int k = 0; k < kStiffenings; ++k) {
    bool hasRoom = true;
    for (Coupling& c : couplings_) {
      const double change = absolute(direction_[c.i] - direction_[c.j]);
      const double room = kShareOfRoom * roomFor(c);
      if (change <= room) continue;
      hasRoom = false;
      c.derivative *= kMoreThanEnough * change / room;
    }
    if (hasRoom) return;
    solve(tolerance, true);
  }
}

/// Computes the direction in which, to first order, the areas become the targets, by conjugate
/// gradients. They start at the last direction if `isGuess`. To add one number to all weights
/// changes no area, so the mean of the direction is set to 0.
///
/// With the couplings' matrix scaled to a diagonal of 1, I + L + U (L below it, U above), the
/// method runs on (I + L)^-1 (I + L + U) (I + U)^-1. This takes half as many steps or less, and a
/// step costs no more: the product with y is t + (I + L)^-1 (y - t), t = (I + U)^-1 y (Eisenstat,
/// Efficient implementation of a class of preconditioned conjugate gradient methods, 1981).
void AreaFitter::solve(double tolerance, bool isGuess) {
  const std::size_t count = targets_.size();
  const CouplingMatrix matrix(count, couplings_);
  FlatArray<double> solution(count, 0), rest(count), way(count), upper(count), image(count);
  for (std::size_t k = 0; k < count; ++k) rest[k] = targets_[k] - best_.areas[k];
  // The sum is zero up to rounding. There is a solution only if it is zero.
  const double surplus = sumOf(rest) / static_cast<double>(count);
  for (std::size_t k = 0; k < count; ++k) rest[k] = matrix.scale(k) * (rest[k] - surplus);
  way = rest;
  matrix.divideByLower(way);
  const double enough = tolerance * tolerance * product(way, way);
  if (isGuess) {
    for (std::size_t k = 0; k < count; ++k) solution[k] = direction_[k] / matrix.scale(k);
    matrix.subtractProduct(solution, rest);
  }
  matrix.divideByLower(rest);
  way = rest;
  double size = product(rest, rest);
  for (std::size_t step = 0; step < 10 * count + 100 && size > enough; ++step) {
    upper = way;
    matrix.divideByUpper(upper);
    for (std::size_t k = 0; k < count; ++k) image[k] = way[k] - upper[k];
    matrix.divideByLower(image);
    for (std::size_t k = 0; k < count; ++k) image[k] += upper[k];
    const double energy = product(way, image);
    if (!(energy > 0)) break;
    const double share = size / energy;
    for (std::size_t k = 0; k < count; ++k) {
      solution[k] += share * upper[k];
      rest[k] -= share * image[k];
    }
    const double next = product(rest, rest), turn = next / size;
    size = next;
    for (std::size_t k = 0; k < count; ++k) way[k] = rest[k] + turn * way[k];
  }
  direction_.resize(count);
  for (std::size_t k = 0; k < count; ++k) direction_[k] = matrix.scale(k) * solution[k];
  const double mean = sumOf(direction_) / static_cast<double>(count);
  for (double& value : direction_) value -= mean;
}

}  // namespace apollonius::internal
