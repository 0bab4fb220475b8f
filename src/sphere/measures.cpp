// In polar coordinates about its site, a cell is the region below the curve rho(phi), so its area
// is
//
//     sum over the sectors of  integral (1 - cos rho) dphi,
//
// and the integral of its points (cos r) u + (sin r)(cos phi e1 + sin phi e2) is
//
//     integral sin² rho / 2 dphi  u  +  integral (rho - sin rho cos rho) / 2 (cos phi e1 + sin phi
//     e2) dphi.
//
// Where the cell ends at its reach, rho is constant and both are elementary. The boundary's length
// is the integral of sqrt(rho'² + sin² rho) dphi.
//
// The integrals are computed by Gauss's rule with twelve points. If the rule with six points agrees
// to more than half of the digits, that with twelve, whose error is about the square, is right to
// all digits; else the interval is halved, unless the difference is rounding.
#include "sphere/measures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "sphere/bisector.h"

namespace apollonius::internal::sphere {

namespace {

struct GaussPoint {
  double position, weight;  // position in [-1, 1], used with both signs
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

/// The integrals to compute over a piece of a bisector.
enum class Integrand : unsigned char { kArea, kAreaAndMoment, kLength };

/// The area below a piece, or its length; and the area's moment in the frame's directions (first,
/// second, up).
struct Integrals {
  double value = 0;
  double rounding = 0;  // approximate error of the value
  Direction moment = {};

  void add(double weight, const SphericalBisector::At& at, Integrand of) {
    if (of == Integrand::kLength) {
      // Rounding that moves rho changes the speed by up to about twice that share.
      const double length = weight * at.speed();
      value += length;
      rounding += 4 * length * at.rounding;
      return;
    }
    value += weight * at.height();
    rounding += weight * at.sine * at.rounding;  // error of the height 1 - cos rho
    if (of == Integrand::kArea) return;
    const double outward = weight * (at.rho() - at.sine * at.cosine) / 2;
    moment = moment + Direction{outward * at.x, outward * at.y, weight * at.sine * at.sine / 2};
  }
};

template <std::size_t n>
Integrals gauss(const SphericalBisector& bisector, double from, double width,
                const std::array<GaussPoint, n>& points, Integrand of) {
  Integrals sum;
  const double half = width / 2, middle = from + half;
  const double cosine = std::cos(middle), sine = std::sin(middle);
  for (const GaussPoint& point : points) {
    const double offset = half * point.position;
    const double c = std::cos(offset), s = std::sin(offset);
    for (const double side : {-s, s})
      sum.add(half * point.weight, bisector.at(cosine * c - sine * side, sine * c + cosine * side),
              of);
  }
  return sum;
}

/// Adds the integrals over an interval of bearings, which is halved as needed.
void addInterval(const SphericalBisector& bisector, double from, double width, Integrand of,
                 Integrals& sum) {
  constexpr int kDeepest = 48;
  // The current part has this number, of 2^depth.
  std::uint64_t number = 0;
  for (int depth = 0; number < std::uint64_t{1} << depth;) {
    const double part = width / static_cast<double>(std::uint64_t{1} << depth);
    const double at = from + part * static_cast<double>(number);
    const Integrals twelve = gauss(bisector, at, part, kTwelvePoints, of);
    const Integrand value = of == Integrand::kAreaAndMoment ? Integrand::kArea : of;
    const double six = gauss(bisector, at, part, kSixPoints, value).value;
    const double enough = 0x1p-30 * twelve.value + twelve.rounding;
    if (std::abs(twelve.value - six) > enough && depth < kDeepest) {
      ++depth;
      number *= 2;
      continue;
    }
    sum.value += twelve.value;
    sum.moment = sum.moment + twelve.moment;
    for (++number; depth > 0 && number % 2 == 0; --depth) number /= 2;
  }
}

/// Adds the area below an arc of a great circle, or its length: by the triangle with the site.
/// REQUIRES: at most half a turn wide.
void addGreatArc(const SphericalBisector& bisector, double from, double width, Integrand of,
                 Integrals& sum) {
  struct Half {
    double sine, cosine;  // sine and cosine of half the distance
  };
  const auto halfOf = [](const SphericalBisector::At& at) {
    const double sine = std::sqrt(at.height() / 2);
    return Half{sine, at.sine / (2 * sine)};
  };
  const Half a = halfOf(bisector.at(from)), b = halfOf(bisector.at(from + width));
  const double sines = a.sine * b.sine, cosines = a.cosine * b.cosine;
  if (of == Integrand::kLength) {
    const double difference = a.sine * b.cosine - a.cosine * b.sine;
    const double across = 2 * std::sqrt(sines * cosines) * std::sin(width / 2);
    sum.value += 2 * std::asin(std::min(std::hypot(difference, across), 1.0));
  } else {
    sum.value += 2 * std::atan2(sines * std::sin(width), cosines + sines * std::cos(width));
  }
}

/// Adds the integrals over a part of a sector. The intervals grow with the distance from the
/// bearing at which the curve turns from one end of the sphere to the other: the turn may be too
/// sharp to be noticed from farther away.
void addEdge(const SphericalBisector& bisector, double from, double width, Integrand of,
             Integrals& sum) {
  constexpr double kWidest = kTurn / 8, kGrowth = 4;
  constexpr double kNarrowest = 0x1p-46;  // smaller steps would be lost in rounding
  if (bisector.isGreatCircle() && of != Integrand::kAreaAndMoment) {
    for (double done = 0; done < width; done += kTurn / 4)
      addGreatArc(bisector, from + done, std::min(kTurn / 4, width - done), of, sum);
    return;
  }
  const SphericalBisector::Turns turns = bisector.turns();
  const double middle = bisector.middle(), to = from + width;
  for (double at = from; at < to;) {
    double behind = kTurn, ahead = kTurn;
    for (const double side : {-turns.aside, turns.aside}) {
      const double away = std::remainder(at - middle - side, kTurn);
      (away < 0 ? ahead : behind) = std::min(away < 0 ? ahead : behind, std::abs(away));
    }
    const double growing = std::min(behind * (kGrowth - 1), ahead * (1 - 1 / kGrowth));
    const double step =
        std::min(std::max({growing, turns.width, kNarrowest}), std::min(kWidest, to - at));
    addInterval(bisector, at, step, of, sum);
    at = step < to - at ? at + step : to;
  }
}

/// Adds the integrals over a part of the circle at the angle `reach`.
void addCircle(double reach, double from, double width, Integrand of, Integrals& sum) {
  if (width == 0) return;
  const double sine = reach < std::numbers::pi ? std::sin(reach) : 0, cosine = std::cos(reach);
  if (of == Integrand::kLength) {
    sum.value += width * sine;
    return;
  }
  const double half = std::sin(reach / 2);
  sum.value += 2 * half * half * width;
  if (of == Integrand::kArea) return;
  // The integrals of the bearings' cosines and sines, from those of the middle.
  const double chord = 2 * std::sin(width / 2), middle = from + width / 2;
  const double outward = (reach - sine * cosine) / 2 * chord;
  sum.moment = sum.moment + Direction{outward * std::cos(middle), outward * std::sin(middle),
                                      width * sine * sine / 2};
}

[[nodiscard]] Integrals integralsOf(const FlatArray<Sector>& sectors, double reach, Integrand of) {
  Integrals sum;
  if (sectors.empty()) {
    // The only site's cell is a whole disc about its centre.
    addCircle(std::min(reach, std::numbers::pi), 0, 2 * std::numbers::pi, of, sum);
    return sum;
  }
  for (const Sector& sector : sectors) {
    double done = 0;  // the part of the sector that is done
    visitWithin(sector, reach, [&](double from, double to) {
      addCircle(reach, sector.from + done, from - done, of, sum);
      addEdge(sector.bisector, sector.from + from, to - from, of, sum);
      done = to;
    });
    addCircle(reach, sector.from + done, sector.width - done, of, sum);
  }
  return sum;
}

double measureAt(const ProjectedDiagram& diagram, VertexId node, CellMeasure measure,
                 const AngularReach& reach, SphericalVertices& vertices,
                 FlatArray<Sector>& sectors) {
  const double most = reach.of(diagram, node);
  if (!(most > 0)) return 0;
  listSectors(diagram, node, vertices, sectors);
  return measure == CellMeasure::kArea ? areaOfCell(diagram.cap(node), sectors, most)
                                       : perimeterOfCell(sectors, most);
}

}  // namespace

double areaOfCell(const Cap& cap, const FlatArray<Sector>& sectors, double reach,
                  Direction* moment) {
  const Integrals sum =
      integralsOf(sectors, reach, moment == nullptr ? Integrand::kArea : Integrand::kAreaAndMoment);
  if (moment != nullptr) {
    const Frame frame(cap.centre);
    *moment = sum.moment.x * frame.first + sum.moment.y * frame.second + sum.moment.z * cap.centre;
  }
  return sum.value;
}

double areaBelow(const SphericalBisector& bisector, double from, double width) {
  Integrals sum;
  addEdge(bisector, from, width, Integrand::kArea, sum);
  return sum.value;
}

double perimeterOfCell(const FlatArray<Sector>& sectors, double reach) {
  return integralsOf(sectors, reach, Integrand::kLength).value;
}

double measureOf(const ProjectedDiagram& diagram, SiteId site, CellMeasure measure,
                 const AngularReach& reach) {
  if (diagram.isHidden(site)) return 0;
  SphericalVertices vertices(diagram, SphericalVertices::Of::kSome);
  FlatArray<Sector> sectors;
  return measureAt(diagram, diagram.nodeOf(site), measure, reach, vertices, sectors);
}

void listMeasures(const ProjectedDiagram& diagram, const SiteTable& sites, CellMeasure measure,
                  const AngularReach& reach, std::vector<double>& measures) {
  measures.assign(sites.idLimit(), 0);
  SphericalVertices vertices(diagram, SphericalVertices::Of::kAll);
  FlatArray<Sector> sectors;
  for (SiteId id = 0; id < sites.idLimit(); ++id) {
    if (sites.has(id) && !diagram.isHidden(id))
      measures[id] = measureAt(diagram, diagram.nodeOf(id), measure, reach, vertices, sectors);
  }
}

}  // namespace apollonius::internal::sphere
