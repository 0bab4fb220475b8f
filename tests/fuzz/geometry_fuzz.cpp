// libFuzzer target: bytes are circles and a window. All shapes, measures and drawings end, and are
// what apollonius/voronoi.h promises: rings are closed and do not cross themselves, areas fill the
// window, here and moved to the origin, points lie in the cell of their nearest site, portions make
// up the whole, and curves have the same bits after any history. How to run: README.md beside this.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "geometry/coverage_judge.h"
#include "geometry/shapes.h"
#include "support/circles_of_bytes.h"
#include "support/operations.h"

namespace apollonius::test {
namespace {

Bounds windowOf(Bytes& bytes, const Circles& circles) {
  Bounds bounds;
  const std::uint8_t kind = bytes.next();
  constexpr double kShares[] = {0, -0.3, 0.4, 30};
  if (kind % 4 < 2 && !circles.empty() && windowAround(circles, kShares[kind >> 2 & 3], bounds))
    return bounds;
  if (kind % 4 == 2 && !circles.empty()) {  // sides through centres
    const auto any = [&]() -> const Circle& { return circles[bytes.next() % circles.size()]; };
    bounds = {any().x, any().y, any().x, any().y};
    if (bounds.xmin > bounds.xmax) std::swap(bounds.xmin, bounds.xmax);
    if (bounds.ymin > bounds.ymax) std::swap(bounds.ymin, bounds.ymax);
    return bounds;
  }
  const auto numbers = static_cast<Numbers>(kind >> 2 & 3);
  const double x = number(bytes, numbers), y = number(bytes, numbers);
  return {x, y, x + number(bytes, numbers), y + number(bytes, numbers)};
}

class Checker {
 public:
  Checker(const Circles& circles, const Bounds& bounds, double tolerance, Random random)
      : circles_(circles),
        bounds_(bounds),
        tolerance_(tolerance),
        random_(random),
        voronoi_(diagram_, bounds) {
    const std::vector<double> xyr = flat(circles);
    std::vector<SiteId> ids(circles.size());
    take(diagram_.insertMany(xyr, ids));
  }

  void run() {
    std::vector<double> areas;
    const Error error = voronoi_.cellAreas(areas);
    if (error == Error::kBadBounds) return;
    take(error);
    whole_ = areaOf(bounds_);
    largest_ = std::max({std::abs(bounds_.xmin), std::abs(bounds_.xmax), std::abs(bounds_.ymin),
                         std::abs(bounds_.ymax)});
    const double narrow = std::min(bounds_.xmax - bounds_.xmin, bounds_.ymax - bounds_.ymin);
    most_ = largest_;
    for (const Circle& c : circles_)
      most_ = std::max({most_, std::abs(c.x), std::abs(c.y), std::abs(c.r)});
    // Vertices are good to 2^-48 of the largest number of their sites (apollonius/diagram.h).
    rounding_ = 1e-9 + 16 * most_ * 0x1p-48 / narrow;
    areApart_ = areApart(narrow);
    checkAreas(areas);
    checkCells();
    checkCoverage();
    checkMoved(areas);
    checkPoints();
    checkEdges();
    checkHull();
    checkDrawings();
    checkHistories();
  }

 private:
  void expect(bool holds, const char* what, SiteId id = kNoSite) {
    if (holds) return;
    std::fprintf(
        stderr, "%s, site %d\nwindow %a %a %a %a (%.17g %.17g %.17g %.17g) tolerance %a\n%s", what,
        static_cast<int>(id), bounds_.xmin, bounds_.ymin, bounds_.xmax, bounds_.ymax, bounds_.xmin,
        bounds_.ymin, bounds_.xmax, bounds_.ymax, tolerance_, toText(insertAll(circles_)).c_str());
    std::abort();
  }
  void take(Error error) { expect(error == Error::kNone, "an error"); }

  /// Are sites, and sides of the window, further apart than doubles of that size, and no cells
  /// needles as thin as that, as where a site all but covers another? Where they are not, rounding
  /// has the last word about rings (apollonius/voronoi.h).
  [[nodiscard]] bool areApart(double narrow) const {
    const double least = 0x1p-36 * most_;
    for (std::size_t k = 0; k < circles_.size(); ++k) {
      for (std::size_t j = 0; j < k; ++j) {
        const Circle &a = circles_[j], &b = circles_[k];
        const double dx = std::abs(a.x - b.x), dy = std::abs(a.y - b.y), dr = std::abs(a.r - b.r);
        const double apart = std::max({dx, dy, dr}), along = std::max(dx, dy),
                     across = std::min(dx, dy);
        if (apart > 0 && apart < least) return false;
        // The conjugate axis of their bisector, squared.
        const double conjugate = across * across + (along - dr) * (along + dr);
        if (conjugate > 0 && conjugate < least * least) return false;
      }
    }
    return narrow >= least;
  }

  void checkAreas(const std::vector<double>& areas) {
    double sum = 0;
    for (SiteId id = 0; id < areas.size(); ++id) {
      CellMeasures one;
      take(voronoi_.cellMeasures(id, one));
      expect(areas[id] >= -rounding_ * whole_, "a negative area", id);
      expect(std::abs(one.area - areas[id]) <= rounding_ * whole_, "area of one cell and of all",
             id);
      sum += areas[id] / whole_;
    }
    if (!circles_.empty() && whole_ > 1e-290)
      expect(std::abs(sum - 1) <= rounding_, "areas do not add up");
  }

  /// The polygons of all cells. Where sites are but a few doubles apart they may be refused
  /// (docs/RELIABILITY.md, "Known limits").
  bool isCovered(const Voronoi& voronoi, CoverageArrays& coverage) {
    const Error error = voronoi.cellPolygons(tolerance_, coverage);
    if (error == Error::kBroken && !areApart_) return false;
    take(error);
    return true;
  }

  void checkCoverage() {
    CoverageArrays coverage;
    if (!isCovered(voronoi_, coverage)) return;
    if (!areApart_ || coverage.coordinates.size() > 2000) return;
    const std::string faults = faultsOf(coverage, bounds_);
    if (!faults.empty()) std::fprintf(stderr, "%s\n", faults.c_str());
    expect(faults.empty(), "polygons do not tile the window");
  }

  void checkCells() {
    rings_.resize(circles_.size());
    for (SiteId id = 0; id < circles_.size(); ++id) {
      take(voronoi_.cellPolygon(id, tolerance_, rings_[id]));
      checkRings(id, rings_[id]);
      CurveArrays cell;
      take(voronoi_.cellCurves(id, cell));
      for (std::size_t region = 0; region + 1 < cell.starts.size(); ++region) {
        const std::uint32_t begin = cell.starts[region], end = cell.starts[region + 1];
        expect(begin < end, "an empty region", id);
        for (std::uint32_t k = begin; k < end; ++k) {
          const double *c = &cell.curves[7 * k],
                       *following = &cell.curves[7 * (k + 1 < end ? k + 1 : begin)];
          expect(std::all_of(c, c + 7, [](double v) { return std::isfinite(v); }),
                 "a curve is not finite", id);
          expect(c[5] == following[0] && c[6] == following[1], "a gap in a boundary", id);
        }
      }
      Circle circle;
      take(diagram_.site(id, circle));
      CellMeasures within;
      const double radius = std::clamp(tolerance_ * std::ldexp(1.0, random_.below(30)),
                                       kSmallestMagnitude, kLargestMagnitude);
      const double distances[] = {radius - circle.r};
      const Reach reach(std::span(&id, 1), distances);
      if (reach.isOutOfRange()) continue;
      take(Voronoi(diagram_, bounds_, &reach).cellMeasures(id, within));
      // The polygon is good to about 2^-48 of the largest number.
      const double seen = radius + 0x1p-45 * most_;
      expect(std::abs(within.area) <= 3.1415926536 * seen * seen * (1 + 1e-9), "more than a disk",
             id);
      expect(std::isfinite(within.perimeter) && within.perimeter >= 0, "a perimeter", id);
    }
  }

  void checkRings(SiteId id, const RingArrays& rings) {
    CellMeasures measures;
    take(voronoi_.cellMeasures(id, measures));
    if (rings.starts.size() < 2)
      expect(measures.area <= rounding_ * whole_, "no ring of a cell", id);
    for (std::size_t r = 0; r + 1 < rings.starts.size(); ++r) {
      std::vector<Point> ring;
      for (std::uint32_t k = rings.starts[r]; k < rings.starts[r + 1]; ++k) {
        const Point p{rings.coordinates[2 * k], rings.coordinates[2 * k + 1]};
        const bool isInside = p.x >= bounds_.xmin && p.x <= bounds_.xmax && p.y >= bounds_.ymin &&
                              p.y <= bounds_.ymax;
        expect(isInside || !areApart_, "a ring outside", id);
        ring.push_back(p);
      }
      expect(ring.size() >= 4 && ring.front() == ring.back(), "an invalid ring", id);
      std::vector<std::pair<double, double>> different;
      for (const Point p : ring) different.emplace_back(p.x, p.y);
      std::sort(different.begin(), different.end());
      different.erase(std::unique(different.begin(), different.end()), different.end());
      expect(different.size() >= 3, "a ring of two points", id);
      if (areApart_ && ring.size() <= 500)
        expect(!crossesItself(ring), "a ring crosses itself", id);
    }
    expect(areaOf(rings) >= -rounding_ * whole_, "clockwise rings", id);
  }

  /// Compares with areas after a corner of the window moved to the origin, where that is exact.
  void checkMoved(const std::vector<double>& areas) {
    bool isExact = true;
    const auto moved = [&](double value, double by) {
      const double there = value - by;
      isExact = isExact && there + by == value && value - there == by;
      return there;
    };
    const auto x = [&](double value) { return moved(value, bounds_.xmin); };
    const auto y = [&](double value) { return moved(value, bounds_.ymin); };
    const Bounds bounds{0, 0, x(bounds_.xmax), y(bounds_.ymax)};
    Diagram diagram;
    for (const Circle& c : circles_) {
      const double there[] = {x(c.x), y(c.y)};
      SiteId id = kNoSite;
      if (!isInRange(there[0]) || !isInRange(there[1])) return;
      take(diagram.insert(there[0], there[1], c.r, id));
    }
    std::vector<double> there;
    if (!isExact || Voronoi(diagram, bounds).cellAreas(there) != Error::kNone) return;
    for (SiteId id = 0; id < areas.size(); ++id) {
      expect(std::abs(areas[id] - there[id]) <= 2 * rounding_ * whole_,
             "another area at the origin", id);
    }
    CoverageArrays coverage;
    if (!isCovered(Voronoi(diagram, bounds), coverage)) return;
    if (!areApart_ || coverage.coordinates.size() > 2000) return;
    const std::string faults = faultsOf(coverage, bounds);
    if (!faults.empty()) std::fprintf(stderr, "%s\n", faults.c_str());
    expect(faults.empty(), "polygons do not tile the window at the origin");
  }

  void checkPoints() {
    // A polygon is at most the tolerance off, and moving by that much changes a difference of
    // distances by twice that.
    const double margin = 2.5 * tolerance_ + 0x1p-36 * most_;
    for (int k = 0; k < 30; ++k) {
      const double x = random_.between(bounds_.xmin, bounds_.xmax),
                   y = random_.between(bounds_.ymin, bounds_.ymax);
      const double toBorder =
          std::min({x - bounds_.xmin, bounds_.xmax - x, y - bounds_.ymin, bounds_.ymax - y});
      if (!isInRange(x) || !isInRange(y) || toBorder <= 0x1p-48 * largest_) continue;
      SiteId nearest = kNoSite;
      double distance = 0, second = std::numeric_limits<double>::infinity();
      take(diagram_.find(x, y, nearest, distance));
      if (nearest == kNoSite) continue;
      for (SiteId id = 0; id < circles_.size(); ++id) {
        if (id != nearest) second = std::min(second, distanceTo(circles_[id], x, y));
      }
      expect(second - distance >= -0x1p-45 * most_, "another site is nearer", nearest);
      if (!(second - distance > margin)) continue;
      for (SiteId id = 0; id < circles_.size(); ++id) {
        expect(isInside(rings_[id], x, y) == (id == nearest), "a point in the wrong polygon", id);
      }
    }
  }

  void checkEdges() {
    CurveArrays edges;
    take(voronoi_.edgeCurves(edges));
    const double slack =
        16 * rounding_ * (bounds_.xmax - bounds_.xmin + bounds_.ymax - bounds_.ymin);
    for (std::size_t k = 0; k < edges.curves.size(); ++k) {
      const double v = edges.curves[k];
      expect(std::isfinite(v), "an edge is not finite");
      const std::size_t part = k % 7;
      if (part == 0 || part == 5)
        expect(v >= bounds_.xmin - slack && v <= bounds_.xmax + slack, "an edge outside");
      if (part == 1 || part == 6)
        expect(v >= bounds_.ymin - slack && v <= bounds_.ymax + slack, "an edge outside");
    }
  }

  void checkHull() {
    std::vector<SiteId> hull;
    take(diagram_.hull(hull));
    expect(hull.empty() == circles_.empty(), "the hull");
    for (const SiteId id : hull) {
      bool hidden = true;
      take(diagram_.isHidden(id, hidden));
      expect(!hidden, "a hidden site on the hull", id);
    }
  }

  void expectFinite(const Path& path) {
    for (const double v : path.coordinates) expect(std::isfinite(v), "a drawing is not finite");
  }

  template <class Draw>
  void checkPortions(Draw&& draw) {
    Path whole, part, joined;
    Portion all, portion{0, 1 + random_.below(std::size_t{20})};
    take(draw(all, whole));
    expect(all.isDone, "a drawing that does not end");
    expectFinite(whole);
    for (std::size_t calls = 0; !portion.isDone; ++calls) {
      expect(calls <= 2 * whole.commands.size() + 4 * circles_.size() + 8,
             "a drawing that does not end");
      take(draw(portion, part));
      joined.commands.insert(joined.commands.end(), part.commands.begin(), part.commands.end());
      joined.coordinates.insert(joined.coordinates.end(), part.coordinates.begin(),
                                part.coordinates.end());
    }
    expect(joined.commands == whole.commands && joined.coordinates == whole.coordinates,
           "portions are not the whole");
  }

  void checkDrawings() {
    using Portion = Portion;
    checkPortions([&](Portion& portion, Path& path) {
      return voronoi_.drawEdges(tolerance_, portion, path);
    });
    checkPortions([&](Portion& portion, Path& path) {
      return voronoi_.drawSites(tolerance_, portion, path);
    });
    checkPortions([&](Portion& portion, Path& path) {
      return voronoi_.drawDual(tolerance_, false, portion, path);
    });
    checkPortions([&](Portion& portion, Path& path) {
      return voronoi_.drawDual(tolerance_, true, portion, path);
    });
    Path path;
    take(voronoi_.drawHull(tolerance_, path));
    expectFinite(path);
    for (SiteId id = 0; id < circles_.size(); ++id) {
      take(voronoi_.drawCell(id, tolerance_, path));
      expectFinite(path);
    }
  }

  void checkHistories() {
    std::vector<std::uint8_t> bytes;
    take(diagram_.toBytes(bytes));
    Diagram restored, reversed;
    take(restored.fromBytes(bytes));
    std::vector<SiteId> ids(circles_.size());
    for (std::size_t k = circles_.size(); k-- > 0;)
      take(reversed.insert(circles_[k].x, circles_[k].y, circles_[k].r, ids[k]));
    for (SiteId id = 0; id < circles_.size(); ++id) {
      bool isHidden = false, isHiddenThere = false;
      take(diagram_.isHidden(id, isHidden));
      take(reversed.isHidden(ids[id], isHiddenThere));
      CurveArrays cell, again;
      take(voronoi_.cellCurves(id, cell));
      take(Voronoi(restored, bounds_).cellCurves(id, again));
      expect(cell.curves == again.curves && cell.starts == again.starts,
             "another cell after a restoration", id);
      if (isHidden != isHiddenThere) continue;  // identical circles have their ids in another order
      take(Voronoi(reversed, bounds_).cellCurves(ids[id], again));
      expect(cell.curves == again.curves && cell.starts == again.starts,
             "another cell after another history", id);
    }
  }

  const Circles& circles_;
  Bounds bounds_;
  double tolerance_;
  Random random_;
  Diagram diagram_;
  Voronoi voronoi_;
  double whole_ = 0, largest_ = 0, most_ = 0, rounding_ = 0;
  bool areApart_ = false;
  std::vector<RingArrays> rings_;
};

void run(Bytes bytes) {
  const std::uint8_t fineness = bytes.next(), seed = bytes.next();
  // Bytes of the window come before those of the circles, which take the rest; but it may be made
  // of the circles.
  std::array<std::uint8_t, 24> ofWindow;
  for (std::uint8_t& byte : ofWindow) byte = bytes.next();
  const Circles circles = circlesOf(bytes);
  Bytes windowBytes(ofWindow);
  const Bounds bounds = windowOf(windowBytes, circles);
  constexpr double kShares[] = {0x1p-13, 1e-4, 0.1, 1e-7};
  const double tolerance = kShares[fineness & 3] * (bounds.xmax - bounds.xmin);
  if (!(tolerance > 0 && tolerance < 1e150)) return;
  Checker(circles, bounds, tolerance, Random(seed)).run();
}

}  // namespace
}  // namespace apollonius::test

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  apollonius::test::run(apollonius::test::Bytes({data, size}));
  return 0;
}
