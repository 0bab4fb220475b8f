// The geometry's interface: errors, portions, and the same bits after any history, natively and as
// WebAssembly.
#include "apollonius/voronoi.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>

#include "geometry/curve/moments.h"
#include "geometry/draw/cubics.h"
#include "geometry/shapes.h"
#include "support/corpus.h"
#include "support/hash.h"
#include "support/replay.h"
#include "support/saved.h"

namespace apollonius::test {

using namespace internal;
namespace {

/// Hash of curves, measures and drawings of a fixed set of diagrams; native code and wasm must
/// agree. Update it only with a change of those formulas that is meant.
constexpr std::uint64_t kExpectedGeometry = 0xf3eef9b813c969ce;

TEST(VoronoiErrors, BadBoundsAndTolerances) {
  Diagram diagram;
  insertInto(diagram, {{1, 2, 1}, {5, 6, 1}});
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN(),
                   kInf = std::numeric_limits<double>::infinity();
  std::vector<double> areas{3};
  for (const Bounds& bad :
       {Bounds{0, 0, 0, 1}, Bounds{0, 0, 1, 0}, Bounds{1, 0, 0, 1}, Bounds{0, 2, 1, 1},
        Bounds{kNan, 0, 1, 1}, Bounds{0, 0, kInf, 1}, Bounds{0, 0, 1, kInf}, Bounds{0, -kInf, 1, 1},
        Bounds{0, 0, 1e101, 1}, Bounds{0, 0, 1e-101, 1}}) {
    const Voronoi voronoi(diagram, bad);
    CurveArrays curves;
    RingArrays rings;
    CoverageArrays coverage;
    CellMeasures measures;
    Path path;
    Portion portion;
    EXPECT_EQ(voronoi.cellAreas(areas), Error::kBadBounds);
    EXPECT_EQ(voronoi.edgeCurves(curves), Error::kBadBounds);
    EXPECT_EQ(voronoi.cellCurves(0, curves), Error::kBadBounds);
    EXPECT_EQ(voronoi.cellPolygon(0, 1, rings), Error::kBadBounds);
    EXPECT_EQ(voronoi.cellPolygons(1, coverage), Error::kBadBounds);
    EXPECT_EQ(voronoi.cellPolygonsBetween(0, 1, 1, coverage), Error::kBadBounds);
    EXPECT_EQ(voronoi.cellMeasures(0, measures), Error::kBadBounds);
    EXPECT_EQ(voronoi.drawEdges(1, portion, path), Error::kBadBounds);
    EXPECT_EQ(voronoi.drawCell(0, 1, path), Error::kBadBounds);
    EXPECT_EQ(areas, std::vector<double>{3}) << "unchanged";
  }
  const Voronoi voronoi(diagram);
  RingArrays rings;
  EXPECT_EQ(voronoi.cellPolygon(0, -1, rings), Error::kOutOfRange);
  EXPECT_EQ(voronoi.cellPolygon(0, kNan, rings), Error::kNotFinite);
  EXPECT_EQ(voronoi.cellPolygon(0, kInf, rings), Error::kNotFinite);
  EXPECT_EQ(voronoi.cellPolygon(2, 1, rings), Error::kUnknownSite);
  CoverageArrays polygons;
  EXPECT_EQ(voronoi.cellPolygonsBetween(0, 1, -1, polygons), Error::kOutOfRange);
  EXPECT_EQ(voronoi.cellPolygonsBetween(0, 1, kNan, polygons), Error::kNotFinite);
  CellMeasures measures;
  EXPECT_EQ(voronoi.cellMeasures(kNoSite, measures), Error::kUnknownSite);
  EXPECT_EQ(voronoi.cellPolygon(0, 1e-300, rings), Error::kNone) << "as fine as it gets";
}

TEST(VoronoiErrors, HiddenSitesHaveNothing) {
  Diagram diagram;
  insertInto(diagram, {{100, 100, 50}, {110, 100, 5}, {300, 300, 5}});
  const Voronoi voronoi(diagram);
  CurveArrays curves;
  RingArrays rings;
  CellMeasures measures;
  Path path;
  ASSERT_EQ(voronoi.cellCurves(1, curves), Error::kNone);
  EXPECT_TRUE(curves.curves.empty());
  EXPECT_EQ(curves.starts.size(), 1u);
  ASSERT_EQ(voronoi.cellPolygon(1, 1, rings), Error::kNone);
  EXPECT_TRUE(rings.coordinates.empty());
  ASSERT_EQ(voronoi.cellMeasures(1, measures), Error::kNone);
  EXPECT_TRUE(measures.isEmpty);
  ASSERT_EQ(voronoi.drawCell(1, 1, path), Error::kNone);
  EXPECT_TRUE(path.commands.empty());
}

TEST(Voronoi, PortionsMakeUpTheWhole) {
  Random random(541);
  const Circles circles = randomCircles(random, 300, Hidden::k20Percent);
  Diagram diagram;
  insertInto(diagram, circles);
  Bounds bounds;
  ASSERT_TRUE(windowAround(circles, -0.2, bounds));
  const Voronoi voronoi(diagram, bounds);
  Path whole, part, joined;
  Portion all;
  ASSERT_EQ(voronoi.drawEdges(100, all, whole), Error::kNone);
  EXPECT_TRUE(all.isDone);
  Portion portion{0, 64};
  int portions = 0;
  while (!portion.isDone) {
    ASSERT_EQ(voronoi.drawEdges(100, portion, part), Error::kNone);
    joined.commands.insert(joined.commands.end(), part.commands.begin(), part.commands.end());
    joined.coordinates.insert(joined.coordinates.end(), part.coordinates.begin(),
                              part.coordinates.end());
    ++portions;
  }
  EXPECT_GT(portions, 2);
  EXPECT_EQ(joined.commands, whole.commands);
  EXPECT_EQ(joined.coordinates, whole.coordinates);
}

TEST(Voronoi, DrawingsAreOnTheCurves) {
  // Ends of drawn pieces are equally far from the two nearest sites; points between them are up to
  // the tolerance, as each of the two distances changes by at most as much as the point moves.
  // Tolerances are small and large, so that all ways of drawing an edge are taken.
  Random random(542);
  for (const double share : {1e-7, 1e-5, 1e-3, 0.03}) {
    const Circles circles = randomCircles(random, 200, Hidden::k50Percent);
    Diagram diagram;
    insertInto(diagram, circles);
    Bounds bounds;
    ASSERT_TRUE(windowAround(circles, 0.1, bounds));
    const double tolerance = share * (bounds.xmax - bounds.xmin);
    const auto difference = [&](double x, double y) {
      double first = 1e300, second = 1e300;
      for (const Circle& c : circles) {
        const double d = distanceTo(c, x, y);
        second = std::min(second, std::max(first, d));
        first = std::min(first, d);
      }
      return second - first;
    };
    Path path;
    Portion portion;
    ASSERT_EQ(Voronoi(diagram, bounds).drawEdges(tolerance, portion, path), Error::kNone);
    double x = 0, y = 0;
    std::size_t at = 0, curves = 0;
    for (std::size_t k = 0; k < path.commands.size(); ++k) {
      const auto command = static_cast<Command>(path.commands[k]);
      const double* xy = path.coordinates.data() + at;
      const bool isCurve = command == Command::kCurve;
      at += isCurve ? 6 : 2;
      curves += isCurve;
      const double endX = path.coordinates[at - 2], endY = path.coordinates[at - 1];
      const bool isLast = k + 1 == path.commands.size() ||
                          static_cast<Command>(path.commands[k + 1]) == Command::kMove;
      if (command == Command::kMove || isLast) {
        ASSERT_LE(difference(endX, endY), 1e-6);
      }
      for (const double t : {0.21, 0.5, 0.77}) {
        if (command == Command::kMove) break;
        const double s = 1 - t;
        const double px = isCurve ? s * s * s * x + 3 * s * s * t * xy[0] + 3 * s * t * t * xy[2] +
                                        t * t * t * xy[4]
                                  : s * x + t * endX;
        const double py = isCurve ? s * s * s * y + 3 * s * s * t * xy[1] + 3 * s * t * t * xy[3] +
                                        t * t * t * xy[5]
                                  : s * y + t * endY;
        ASSERT_LE(difference(px, py), 2.01 * tolerance) << "share " << share;
      }
      x = endX;
      y = endY;
    }
    EXPECT_EQ(curves > 20, share < 0.01) << curves;
  }
}

/// Adds the curves of cells, their measures and their approximations. Where a boundary starts
/// depends on the history; which curves it has does not.
void add(const Voronoi& voronoi, const std::vector<SiteId>& order, double tolerance, Hash& hash) {
  for (const SiteId id : order) {
    CurveArrays cell;
    ASSERT_EQ(voronoi.cellCurves(id, cell), Error::kNone);
    std::vector<std::vector<double>> curves;
    for (std::size_t k = 0; k + 6 < cell.curves.size(); k += 7)
      curves.emplace_back(&cell.curves[k], &cell.curves[k] + 7);
    std::sort(curves.begin(), curves.end());
    for (const std::vector<double>& c : curves) {
      for (const double number : c) hash.add(number + 0.0);  // -0 and 0 sort as equals
      const Conic conic{{c[0], c[1]}, {c[2], c[3]}, c[4], {c[5], c[6]}};
      Path path;
      drawConic(conic, {tolerance}, path);
      Moments moments;
      moments.add(conic, {1, 2});
      hash.addAll(path.coordinates);
      for (const Point p : chordsOf(conic, tolerance)) {
        hash.add(p.x + 0.0);
        hash.add(p.y + 0.0);
      }
      for (const double number :
           {lengthOf(conic), areaBeyondChord(conic), moments.first.x, moments.first.y})
        hash.add(number + 0.0);
    }
  }
}

TEST(VoronoiDeterminism, CurvesHaveTheSameBitsAfterAnyHistory) {
  for (const NamedGenerator& generator : corpus()) {
    SCOPED_TRACE(generator.name);
    Random random(543);
    const Circles circles = generator.make(random, generator.large ? 40 : 8);
    Bounds bounds;
    if (!windowAround(circles, -0.1, bounds)) continue;
    Hash hashes[2];
    for (int run = 0; run < 2; ++run) {
      Diagram diagram;
      std::vector<SiteId> order(circles.size());
      for (std::size_t k = 0; k < circles.size(); ++k) {
        const std::size_t which = run == 0 ? k : circles.size() - 1 - k;
        ASSERT_EQ(
            diagram.insert(circles[which].x, circles[which].y, circles[which].r, order[which]),
            Error::kNone);
      }
      if (run == 1) {  // among identical circles the last one, inserted first, is visible
        for (SiteId& id : order) {
          bool hidden = false;
          ASSERT_EQ(diagram.isHidden(id, hidden), Error::kNone);
          if (hidden) id = kNoSite;
        }
      }
      std::vector<SiteId> visible;
      for (const SiteId id : order) {
        bool hidden = true;
        if (id != kNoSite) {
          ASSERT_EQ(diagram.isHidden(id, hidden), Error::kNone);
        }
        if (!hidden) visible.push_back(id);
      }
      std::sort(visible.begin(), visible.end(), [&](SiteId a, SiteId b) {
        Circle p{}, q{};
        EXPECT_EQ(diagram.site(a, p), Error::kNone);
        EXPECT_EQ(diagram.site(b, q), Error::kNone);
        return std::tie(p.r, p.x, p.y) < std::tie(q.r, q.x, q.y);
      });
      add(Voronoi(diagram, bounds), visible, 1e-4 * (bounds.xmax - bounds.xmin), hashes[run]);
    }
    EXPECT_EQ(hashes[0].value(), hashes[1].value());
  }
}

/// Length of the chords of a path's pieces.
double lengthOf(const Path& path) {
  double length = 0, x = 0, y = 0;
  const double* xy = path.coordinates.data();
  for (const std::uint8_t command : path.commands) {
    xy += static_cast<Command>(command) == Command::kCurve ? 6 : 2;
    if (static_cast<Command>(command) != Command::kMove)
      length += std::hypot(xy[-2] - x, xy[-1] - y);
    x = xy[-2];
    y = xy[-1];
  }
  return length;
}

TEST(VoronoiDeterminism, RestoredDiagramsHaveTheSameShapes) {
  // A restored diagram has none of its circles at first: each question is the first one.
  for (const NamedGenerator& generator : corpus()) {
    SCOPED_TRACE(generator.name);
    Random random(545);
    const Circles circles = generator.make(random, generator.large ? 60 : 8);
    Bounds bounds;
    if (!windowAround(circles, -0.1, bounds)) continue;
    const double size = std::max(bounds.xmax - bounds.xmin, bounds.ymax - bounds.ymin),
                 tolerance = 1e-4 * size;
    const double largest = std::max({std::abs(bounds.xmin), std::abs(bounds.xmax),
                                     std::abs(bounds.ymin), std::abs(bounds.ymax)});
    Diagram original;
    insertInto(original, circles);
    const std::vector<std::uint8_t> bytes = saved(original);
    const auto onBoth = [&](auto&& ask) {
      Diagram restored;
      ASSERT_EQ(restored.fromBytes(bytes, Source::kTrusted), Error::kNone);
      ask(Voronoi(original, bounds), Voronoi(restored, bounds));
    };
    onBoth([](const Voronoi& a, const Voronoi& b) {
      CurveArrays curves, same;
      ASSERT_EQ(a.edgeCurves(curves), Error::kNone);
      ASSERT_EQ(b.edgeCurves(same), Error::kNone);
      EXPECT_EQ(curves.curves, same.curves);
      EXPECT_EQ(curves.sites, same.sites);
    });
    onBoth([&](const Voronoi& a, const Voronoi& b) {
      for (SiteId id = 0; id < circles.size(); ++id) {
        CurveArrays cell, same;
        ASSERT_EQ(a.cellCurves(id, cell), Error::kNone);
        ASSERT_EQ(b.cellCurves(id, same), Error::kNone);
        EXPECT_EQ(cell.curves, same.curves);
      }
    });
    onBoth([&](const Voronoi& a, const Voronoi& b) {
      std::vector<double> areas, same;
      ASSERT_EQ(a.cellAreas(areas), Error::kNone);
      ASSERT_EQ(b.cellAreas(same), Error::kNone);
      ASSERT_EQ(areas.size(), same.size());
      for (std::size_t k = 0; k < areas.size(); ++k)
        EXPECT_NEAR(areas[k], same[k], 1e-11 * size * largest);
    });
    onBoth([&](const Voronoi& a, const Voronoi& b) {
      Path path, same;
      Portion portion, again;
      ASSERT_EQ(a.drawEdges(tolerance, portion, path), Error::kNone);
      ASSERT_EQ(b.drawEdges(tolerance, again, same), Error::kNone);
      // Last bits decide in which of several ways an edge is drawn, and when.
      EXPECT_NEAR(lengthOf(path), lengthOf(same),
                  tolerance * static_cast<double>(path.commands.size()));
    });
    onBoth([&](const Voronoi& a, const Voronoi& b) {
      Path path, same;
      Portion portion, again;
      ASSERT_EQ(a.drawDual(tolerance, true, portion, path), Error::kNone);
      ASSERT_EQ(b.drawDual(tolerance, true, again, same), Error::kNone);
      EXPECT_EQ(path.commands, same.commands);
    });
  }
}

TEST(VoronoiSites, AllCirclesAreDrawnHiddenOnesTooAndPointsAreNot) {
  Diagram diagram;
  insertInto(diagram, {{3, 4, 2}, {10, 4, 0}, {3, 4, 1}});
  const Voronoi voronoi(diagram, {0, 0, 20, 20});
  Path whole;
  Portion all;
  ASSERT_EQ(voronoi.drawSites(1e-3, all, whole), Error::kNone);
  EXPECT_TRUE(all.isDone);
  EXPECT_EQ(whole.commands.size(), 12u) << "twice: move, four quarters, close";

  Path path;
  Portion portion;
  portion.commands = 1;
  std::size_t commands = 0, calls = 0;
  for (; !portion.isDone; ++calls) {
    ASSERT_LT(calls, 5u);
    ASSERT_EQ(voronoi.drawSites(1e-3, portion, path), Error::kNone);
    commands += path.commands.size();
  }
  EXPECT_EQ(commands, whole.commands.size());
  EXPECT_GE(calls, 2u);
}

TEST(VoronoiSites, RemovedOnesAreNotDrawn) {
  Diagram diagram;
  insertInto(diagram, {{3, 4, 2}, {10, 4, 2}});
  const Voronoi voronoi(diagram, {0, 0, 20, 20});
  bool removed = false;
  ASSERT_EQ(diagram.remove(0, removed), Error::kNone);
  Path path;
  Portion portion;
  ASSERT_EQ(voronoi.drawSites(1e-3, portion, path), Error::kNone);
  EXPECT_EQ(path.commands.size(), 6u);
  CoverageArrays polygons;
  ASSERT_EQ(voronoi.cellPolygons(1e-3, polygons), Error::kNone);
  EXPECT_EQ(polygons.sites, std::vector<SiteId>{1});
}

TEST(Voronoi, PolygonsOfManyCellsAreThoseOfEach) {
  Random random(546);
  const Circles circles = randomCircles(random, 300, Hidden::k20Percent);
  Diagram diagram;
  insertInto(diagram, circles);
  for (SiteId id = 0; id < 300; id += 7) {
    bool removed = false;
    ASSERT_EQ(diagram.remove(id, removed), Error::kNone);
  }
  Bounds bounds;
  ASSERT_TRUE(windowAround(circles, -0.2, bounds));  // cells leave it, in parts
  const Voronoi voronoi(diagram, bounds);
  CoverageArrays many;
  RingArrays one;
  for (const auto& [first, end] :
       {std::pair{0u, 300u}, {40u, 170u}, {290u, 0xFFFFFFFFu}, {5u, 5u}}) {
    ASSERT_EQ(voronoi.cellPolygonsBetween(first, end, 0.01, many), Error::kNone);
    std::size_t k = 0;
    for (SiteId id = first; id < std::min(end, 300u); ++id) {
      if (id % 7 == 0) continue;
      ASSERT_EQ(voronoi.cellPolygon(id, 0.01, one), Error::kNone);
      if (one.coordinates.empty()) continue;
      ASSERT_LT(k, many.sites.size());
      EXPECT_EQ(many.sites[k], id);
      const std::size_t part = many.cells[k], ring = many.parts[part], point = many.starts[ring];
      ASSERT_EQ(many.cells[k + 1] - part, one.parts.size() - 1);
      for (std::size_t m = 0; m < one.parts.size(); ++m)
        EXPECT_EQ(many.parts[part + m] - ring, one.parts[m]);
      for (std::size_t m = 0; m < one.starts.size(); ++m)
        EXPECT_EQ(many.starts[ring + m] - point, one.starts[m]);
      EXPECT_TRUE(std::equal(one.coordinates.begin(), one.coordinates.end(),
                             many.coordinates.begin() + static_cast<std::ptrdiff_t>(2 * point)));
      ++k;
    }
    EXPECT_EQ(k, many.sites.size());
    EXPECT_EQ(many.cells.size(), k + 1);
  }
}

/// The weights of curves as short as these are 1 up to rounding, which can take them below.
TEST(Voronoi, ShortEdgesAreDrawnFromEndToEnd) {
  Random random(545);
  Circles circles;
  const auto jitter = [&] { return random.between(-1e-9, 1e-9); };
  for (int k = 0; k < 400; ++k)
    circles.push_back({k % 20 + jitter(), k / 20 + jitter(), 1e-9 + jitter()});
  Diagram diagram;
  insertInto(diagram, circles);
  Bounds bounds;
  ASSERT_TRUE(windowAround(circles, 0.1, bounds));
  const Voronoi voronoi(diagram, bounds);
  const auto lengthAt = [&](double tolerance) {
    Path path;
    Portion portion;
    EXPECT_EQ(voronoi.drawEdges(tolerance, portion, path), Error::kNone);
    double sum = 0;
    Point last{};
    std::size_t at = 0;
    for (const std::uint8_t code : path.commands) {
      at += static_cast<Command>(code) == Command::kCurve ? 6 : 2;
      const Point next{path.coordinates[at - 2], path.coordinates[at - 1]};
      if (static_cast<Command>(code) != Command::kMove) sum += length(next - last);
      last = next;
    }
    return sum;
  };
  const double expected = lengthAt(1);
  EXPECT_NEAR(lengthAt(1e-300), expected, 1e-9 * expected);
}

TEST(VoronoiDeterminism, HashOfGeometry) {
  Hash hash;
  for (const NamedGenerator& generator : corpus()) {
    Random random(544);
    const Circles circles = generator.make(random, generator.large ? 50 : 8);
    Bounds bounds;
    if (!windowAround(circles, -0.2, bounds)) continue;
    Diagram diagram;
    insertInto(diagram, circles);
    const Voronoi voronoi(diagram, bounds);
    std::vector<SiteId> ids;
    ASSERT_EQ(diagram.ids(ids), Error::kNone);
    add(voronoi, ids, 1e-4 * (bounds.xmax - bounds.xmin), hash);
  }
  std::printf("geometry %#018llx\n", static_cast<unsigned long long>(hash.value()));
  EXPECT_EQ(hash.value(), kExpectedGeometry) << std::hex << hash.value();
}

}  // namespace
}  // namespace apollonius::test
