// In polar coordinates about its site a cell is what is below the curve rho(phi), so its area is
//
//     sum over the sectors of  integral (1 - cos rho) dphi,
//
// and the integral of its points (cos r) u + (sin r)(cos phi e1 + sin phi e2) is
//
//     integral sin² rho / 2 dphi  u  +  integral (rho - sin rho cos rho) / 2 (cos phi e1 + sin phi
//     e2) dphi.
//
// Both are taken by Gauss's rule of twelve points. Where the rule of six agrees to more than half
// of the digits, that of twelve, whose error is about the square, is right to all of them; else the
// interval is halved, unless rounding makes the difference.
#include "sphere/measures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "sphere/bisector.h"

namespace apollonius::internal::sphere {

namespace {

struct GaussPoint {
  double position, weight;  // in [-1, 1], of both signs
};
constexpr std::array<GaussPoint, 6> kTwelvePoints = {{{0.1252334085114689, 0.24914704581340277},
                                                      {0.3678314989981802, 0.2334925365383548},
                                                      {0.5873179542866175, 0.20316742672306592},
                                                      {0.7699026741943047, 0.16007832854334622},
                                                      {0.9041172563704749, 0.10693932599531843},
                                                      {0.9815606342467192, 0.04717533638651183}}};
constexpr std::array<GaussPoint, 3> kSixPoints = {{{0.2386191860831969, 0.46791393457269104},
                                                   {0.6612093864662645, 0.3607615730481386},
                                                   {0.932469514203152, 0.17132449237917036}}};

/// The area below a piece of a bisector, and what it adds to the moment in the frame's directions
/// (first, second, up).
struct Integrals {
  double area = 0;
  double rounding = 0;  // of the area, about
  Direction moment = {};

  void add(double weight, const SphericalBisector::At& at, bool withMoment) {
    area += weight * at.height();
    rounding += weight * at.sine * at.rounding;  // of the height 1 - cos rho
    if (!withMoment) return;
    const double outward = weight * (at.rho() - at.sine * at.cosine) / 2;
    moment = moment + Direction{outward * at.x, outward * at.y, weight * at.sine * at.sine / 2};
  }
};

template <std::size_t n>
Integrals gauss(const SphericalBisector& bisector, double from, double width,
                const std::array<GaussPoint, n>& points, bool withMoment) {
  Integrals sum;
  const double half = width / 2, middle = from + half;
  const double cosine = std::cos(middle), sine = std::sin(middle);
  for (const GaussPoint& point : points) {
    const double offset = half * point.position;
    const double c = std::cos(offset), s = std::sin(offset);
    for (const double side : {-s, s})
      sum.add(half * point.weight, bisector.at(cosine * c - sine * side, sine * c + cosine * side),
              withMoment);
  }
  return sum;
}

/// Adds the integrals over an interval of bearings, halved where that is needed.
void addInterval(const SphericalBisector& bisector, double from, double width, bool withMoment,
                 Integrals& sum) {
  constexpr int kDeepest = 48;
  // The part under way is the one with this number of 2^depth.
  std::uint64_t number = 0;
  for (int depth = 0; number < std::uint64_t{1} << depth;) {
    const double part = width / static_cast<double>(std::uint64_t{1} << depth);
    const double at = from + part * static_cast<double>(number);
    const Integrals twelve = gauss(bisector, at, part, kTwelvePoints, withMoment);
    const double six = gauss(bisector, at, part, kSixPoints, false).area;
    const double enough = 0x1p-30 * twelve.area + twelve.rounding;
    if (std::abs(twelve.area - six) > enough && depth < kDeepest) {
      ++depth;
      number *= 2;
      continue;
    }
    sum.area += twelve.area;
    sum.moment = sum.moment + twelve.moment;
    for (++number; depth > 0 && number % 2 == 0; --depth) number /= 2;
  }
}

/// Adds the integrals over a sector in intervals that grow with the distance from where the curve
/// turns from one end of the sphere to the other, too sharply perhaps to be seen from farther away.
void addSector(const Sector& sector, bool withMoment, Integrals& sum) {
  constexpr double kTurn = 2 * std::numbers::pi, kWidest = kTurn / 8, kGrowth = 4;
  constexpr double kNarrowest = 0x1p-46;  // of steps, which rounding would swallow
  const SphericalBisector& bisector = sector.bisector;
  const SphericalBisector::Turns turns = bisector.turns();
  const double middle = bisector.middle(), to = sector.from + sector.width;
  for (double at = sector.from; at < to;) {
    double behind = kTurn, ahead = kTurn;
    for (const double side : {-turns.aside, turns.aside}) {
      const double away = std::remainder(at - middle - side, kTurn);
      (away < 0 ? ahead : behind) = std::min(away < 0 ? ahead : behind, std::abs(away));
    }
    const double growing = std::min(behind * (kGrowth - 1), ahead * (1 - 1 / kGrowth));
    const double step =
        std::min(std::max({growing, turns.width, kNarrowest}), std::min(kWidest, to - at));
    addInterval(bisector, at, step, withMoment, sum);
    at = step < to - at ? at + step : to;
  }
}

}  // namespace

double areaOfCell(const Cap& cap, const FlatArray<Sector>& sectors, Direction* moment) {
  if (sectors.size() == 0) {
    if (moment != nullptr) *moment = {};
    return 4 * std::numbers::pi;
  }
  Integrals sum;
  for (const Sector& sector : sectors) {
    addSector(sector, moment != nullptr, sum);
  }
  if (moment != nullptr) {
    const Frame frame(cap.centre);
    *moment = sum.moment.x * frame.first + sum.moment.y * frame.second + sum.moment.z * cap.centre;
  }
  return sum.area;
}

void listAreas(const ProjectedDiagram& diagram, const SiteTable& sites,
               std::vector<double>& areas) {
  areas.assign(sites.idLimit(), 0);
  SphericalVertices vertices(diagram, SphericalVertices::Of::kAll);
  FlatArray<Sector> sectors;
  for (SiteId id = 0; id < sites.idLimit(); ++id) {
    if (!sites.has(id) || diagram.isHidden(id)) continue;
    const VertexId node = diagram.nodeOf(id);
    listSectors(diagram, node, vertices, sectors);
    areas[id] = areaOfCell(diagram.cap(node), sectors);
  }
}

}  // namespace apollonius::internal::sphere
