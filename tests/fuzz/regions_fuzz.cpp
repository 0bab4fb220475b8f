// libFuzzer target: bytes are circles and rings. Whatever the rings are, a region of them ends, and
// is what apollonius/region.h promises: areas add up to it, those of all cells are those of each,
// boundaries are closed, all is finite; and steps towards prescribed areas end and change nothing.
// How to run: README.md beside this.
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "apollonius/area_fit.h"
#include "geometry/shapes.h"
#include "support/circles_of_bytes.h"

namespace apollonius::test {
namespace {

void expect(bool holds, const char* what, SiteId id = kNoSite) {
  if (holds) return;
  std::fprintf(stderr, "%s, site %d\n", what, static_cast<int>(id));
  std::abort();
}

void take(Error error) { expect(error == Error::kNone, "an error"); }

/// Rings of a region; some have corners at centres.
void ringsOf(Bytes& bytes, const Circles& circles, std::vector<double>& coordinates,
             std::vector<std::uint32_t>& starts) {
  const std::uint8_t kind = bytes.next();
  const auto numbers = static_cast<Numbers>(kind & 3);
  const std::size_t rings = 1 + (kind >> 2) % 3;
  starts.assign(1, 0);
  for (std::size_t ring = 0; ring < rings; ++ring) {
    const std::size_t count = 3 + bytes.next() % 8;
    for (std::size_t k = 0; k < count; ++k) {
      if ((kind & 0x40) != 0 && !circles.empty()) {
        const Circle& circle = circles[bytes.next() % circles.size()];
        coordinates.insert(coordinates.end(), {circle.x, circle.y});
      } else {
        const double x = number(bytes, numbers), y = number(bytes, numbers);
        coordinates.insert(coordinates.end(), {x, y});
      }
    }
    starts.push_back(static_cast<std::uint32_t>(coordinates.size() / 2));
  }
}

void checkCells(const Voronoi& voronoi, const std::vector<double>& areas, double whole,
                double rounding) {
  for (SiteId id = 0; id < areas.size(); ++id) {
    CellMeasures measures;
    take(voronoi.cellMeasures(id, measures));
    expect(std::abs(measures.area - areas[id]) <= rounding * whole, "areas of one and of all", id);
    expect(std::isfinite(measures.perimeter) && std::isfinite(measures.centroidX), "infinite", id);
    CurveArrays cell;
    take(voronoi.cellCurves(id, cell));
    for (std::size_t ring = 0; ring + 1 < cell.starts.size(); ++ring) {
      const std::uint32_t begin = cell.starts[ring], end = cell.starts[ring + 1];
      for (std::uint32_t k = begin; k < end; ++k) {
        const double *c = &cell.curves[7 * k],
                     *next = &cell.curves[7 * (k + 1 < end ? k + 1 : begin)];
        expect(c[5] == next[0] && c[6] == next[1], "a gap", id);
      }
    }
    RingArrays rings;
    take(voronoi.cellPolygon(id, 0.01 * std::sqrt(whole), rings));
  }
}

void run(Bytes bytes) {
  std::uint8_t ofRings[64];
  for (std::uint8_t& byte : ofRings) byte = bytes.next();
  const Circles circles = circlesOf(bytes);
  Bytes ringBytes(ofRings);
  std::vector<double> coordinates;
  std::vector<std::uint32_t> starts;
  ringsOf(ringBytes, circles, coordinates, starts);
  Region region;
  const Error error = region.assign(coordinates, starts);
  if (error == Error::kBadBounds) return;
  take(error);

  Diagram diagram;
  insertInto(diagram, circles);
  const Voronoi voronoi(diagram, region);
  std::vector<double> areas, others;
  take(voronoi.cellAreas(areas));
  take(voronoi.cellCentroids(others));
  take(voronoi.cellPerimeters(others));
  const Bounds box = region.box();
  const double whole = areaOf(box);
  // Rounding grows with distance and size.
  double most = 0;
  for (const double x : coordinates) most = std::max(most, std::abs(x));
  for (const Circle& c : circles)
    most = std::max({most, std::abs(c.x), std::abs(c.y), std::abs(c.r)});
  const double narrow = std::min(box.xmax - box.xmin, box.ymax - box.ymin);
  const double rounding = 1e-9 + 16 * most * 0x1p-48 / narrow;
  if (!(rounding < 1e-3) || !(whole > 1e-200 && whole < 1e200)) return;
  double sum = 0;
  for (const double area : areas) sum += area;
  if (diagram.visibleSize() > 0)
    expect(std::abs(sum - region.area()) <= rounding * whole, "areas do not add up");
  checkCells(voronoi, areas, whole, rounding);
  Portion portion;
  Path path;
  take(voronoi.drawEdges(1e-3 * std::sqrt(whole), portion, path));
  expect(portion.isDone, "not all drawn");

  AreaFit fit;
  if (fit.begin(diagram, region, std::vector<double>(areas.size(), 1)) != Error::kNone) return;
  for (int step = 0; step < 3 && fit.step() == Error::kNone; ++step) {
  }
}

}  // namespace
}  // namespace apollonius::test

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  apollonius::test::run(apollonius::test::Bytes({data, size}));
  return 0;
}
