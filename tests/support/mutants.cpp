#include "support/mutants.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <initializer_list>

#include "apollonius/area_fit.h"
#include "apollonius/nearest_first.h"
#include "apollonius/voronoi.h"
#include "support/canonical.h"
#include "support/replay.h"
#include "support/snapshots.h"

namespace apollonius::test {

namespace {

/// The parts of a snapshot (docs/SNAPSHOTS.md), as numbers of words.
struct Layout {
  std::size_t slots, ids, sites, hidden, faces;
  std::size_t numbersAt, idsAt, twinsAt, verticesAt, forestAt;

  explicit Layout(const std::vector<std::uint8_t>& bytes) {
    slots = wordAt(bytes, 3), ids = wordAt(bytes, 4), sites = wordAt(bytes, 5);
    hidden = wordAt(bytes, 6), faces = wordAt(bytes, 7);
    numbersAt = kNumbersAt;
    idsAt = numbersAt + 6 * slots;
    twinsAt = idsAt + slots + (slots - sites) + (ids - sites) + 2;
    verticesAt = twinsAt + 3 * faces;
    forestAt = verticesAt + slots + 1;
  }
};

void changeNumber(std::vector<std::uint8_t>& bytes, const Layout& at, Random& random) {
  const auto any = [&] {
    return at.numbersAt + 6 * random.below(at.slots) + 2 * random.below(std::size_t{3});
  };
  const std::size_t k = any(), other = any();
  const double value = numberAt(bytes, k), another = numberAt(bytes, other);
  switch (random.below(6u)) {
    case 0:
      return setNumber(bytes, k, another);
    case 1:
      setNumber(bytes, k, another);
      return setNumber(bytes, other, value);
    case 2:
      return setNumber(bytes, k, value + (another - value) * random.unit());
    case 3:
      return setNumber(bytes, k, value * (random.oneIn(2) ? 1 + 0x1p-40 : 1 + 0x1p-10));
    case 4:
      return setNumber(bytes, k, static_cast<double>(random.integer(-10, 10)));
    default:
      return setWord(bytes, k + random.below(std::size_t{2}),
                     static_cast<std::uint32_t>(random.next()));
  }
}

/// The site of one slot, and that of another, are exchanged, or one becomes the other.
void exchangeSites(std::vector<std::uint8_t>& bytes, const Layout& at, Random& random) {
  const std::size_t a = at.numbersAt + 6 * random.below(at.slots),
                    b = at.numbersAt + 6 * random.below(at.slots);
  const bool isCopy = random.oneIn(3);
  for (std::size_t k = 0; k < 6; ++k) {
    const std::uint32_t old = wordAt(bytes, a + k);
    setWord(bytes, a + k, wordAt(bytes, b + k));
    if (!isCopy) setWord(bytes, b + k, old);
  }
}

/// Two pairs of twins are sewn another way.
void exchangeTwins(std::vector<std::uint8_t>& bytes, const Layout& at, Random& random) {
  const auto any = [&] { return static_cast<std::uint32_t>(random.below(3 * at.faces)); };
  const std::uint32_t a = any(), b = any();
  const std::uint32_t c = wordAt(bytes, at.twinsAt + a), d = wordAt(bytes, at.twinsAt + b);
  if (c >= 3 * at.faces || d >= 3 * at.faces) return;
  setWord(bytes, at.twinsAt + a, d), setWord(bytes, at.twinsAt + d, a);
  setWord(bytes, at.twinsAt + b, c), setWord(bytes, at.twinsAt + c, b);
}

/// The edge of half-edge h becomes the other diagonal of its two faces, as in tests/graph: the
/// surface is a closed one as before.
void flipEdge(std::vector<std::uint8_t>& bytes, const Layout& at, Random& random) {
  const auto next = [](std::uint32_t h) { return h % 3 == 2 ? h - 2 : h + 1; };
  const auto twin = [&](std::uint32_t h) { return wordAt(bytes, at.twinsAt + h); };
  const auto h = static_cast<std::uint32_t>(random.below(3 * at.faces)), t = twin(h);
  if (t >= 3 * at.faces) return;
  const std::uint32_t hn = next(h), hp = next(hn), tn = next(t), tp = next(tn);
  const std::uint32_t outer[] = {twin(hn), twin(hp), twin(tn), twin(tp)};
  for (const std::uint32_t o : outer) {
    if (o >= 3 * at.faces || o == hn || o == hp || o == tn || o == tp) return;
  }
  // Who starts where, told by the half-edges of the vertices: those of the four corners get one
  // that does.
  const auto origin = [&](std::uint32_t g) -> std::size_t {
    for (std::uint32_t around = g, steps = 0; steps < 3 * at.faces; ++steps) {
      for (std::size_t v = 0; v <= at.slots; ++v) {
        if (wordAt(bytes, at.verticesAt + v) == around) return v;
      }
      const std::uint32_t before = next(next(around));
      if (twin(before) >= 3 * at.faces) break;
      around = twin(before);
    }
    return at.slots + 1;
  };
  const std::size_t a = origin(h), b = origin(hn), c = origin(hp), d = origin(tp);
  if (std::max({a, b, c, d}) > at.slots) return;
  const auto sew = [&](std::uint32_t x, std::uint32_t y) {
    setWord(bytes, at.twinsAt + x, y), setWord(bytes, at.twinsAt + y, x);
  };
  sew(hn, outer[3]), sew(hp, outer[0]), sew(tn, outer[1]), sew(tp, outer[2]);
  setWord(bytes, at.verticesAt + a, tp), setWord(bytes, at.verticesAt + b, hp);
  setWord(bytes, at.verticesAt + c, h), setWord(bytes, at.verticesAt + d, t);
}

void expect(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "%s\n", what);
  std::abort();
}

}  // namespace

std::vector<std::uint8_t> mutant(const std::vector<std::uint8_t>& snapshot, Random& random,
                                 std::uint64_t changes) {
  std::vector<std::uint8_t> bytes = snapshot;
  const Layout at(snapshot);
  const std::size_t words = bytes.size() / 4 - 2;
  for (; changes > 0; --changes) {
    const std::uint64_t kind = random.below(16u);
    if (kind < 5 && at.slots > 0) {
      changeNumber(bytes, at, random);
    } else if (kind < 8 && at.slots > 0) {
      exchangeSites(bytes, at, random);
    } else if (kind < 12 && at.faces > 0) {
      flipEdge(bytes, at, random);
    } else if (kind == 12 && at.faces > 0) {
      exchangeTwins(bytes, at, random);
    } else if (kind == 13 && at.hidden > 0) {
      const std::size_t k = at.forestAt + random.below(2 * at.hidden);
      setWord(bytes, k, static_cast<std::uint32_t>(random.below(at.slots)));
    } else if (kind == 14) {
      const std::size_t a = random.below(words), b = random.below(words);
      const std::uint32_t old = wordAt(bytes, a);
      setWord(bytes, a, wordAt(bytes, b)), setWord(bytes, b, old);
    } else {
      const std::size_t k = 2 + random.below(words - 2);
      setWord(bytes, k,
              random.oneIn(4) ? 0xFFFFFFFFu : static_cast<std::uint32_t>(random.below(words)));
    }
  }
  return withChecksum(bytes);
}

std::vector<std::uint8_t> mutant(const std::vector<std::uint8_t>& snapshot, Random& random) {
  return mutant(snapshot, random, 1 + random.below(4u));
}

std::string whatIsWrong(const Diagram& diagram, Random& random) {
  std::string broken;
  if (diagram.validate(broken) != Error::kNone || !broken.empty()) return "validate: " + broken;
  const Canonical form = canonicalForm(diagram, broken);
  if (!broken.empty()) return broken;
  const Canonical fresh = freshBuild(form.circles, Build::kOneByOne, Location::kHierarchy, broken);
  if (!broken.empty()) return broken;
  if (const std::string other = difference(fresh, form); !other.empty()) return other;
  std::vector<SiteId> ids;
  if (diagram.ids(ids) != Error::kNone || ids.size() != form.circles.size()) return "ids";
  Circles circles;
  for (const SiteId id : ids) {
    circles.emplace_back();
    if (diagram.site(id, circles.back()) != Error::kNone) return "site";
  }
  for (int k = 0; k < 8 && !ids.empty(); ++k) {
    const Circle &a = circles[random.below(circles.size())],
                 &b = circles[random.below(circles.size())];
    const double x = random.oneIn(2) ? a.x : a.x / 2 + b.x / 2,
                 y = random.oneIn(2) ? b.y : a.y / 2 + b.y / 2;
    if ((x != 0 && std::abs(x) < kSmallestMagnitude) ||
        (y != 0 && std::abs(y) < kSmallestMagnitude))
      continue;
    SiteId found = kNoSite;
    double distance = 0;
    if (diagram.find(x, y, found, distance) != Error::kNone) return "find failed";
    const auto place = std::lower_bound(ids.begin(), ids.end(), found) - ids.begin();
    const Circle& near = circles[static_cast<std::size_t>(place)];
    const Circle& nearest = circles[static_cast<std::size_t>(oracleNearest(circles, x, y))];
    if (near.x != nearest.x || near.y != nearest.y || near.r != nearest.r) return "find is wrong";
  }
  return {};
}

namespace {

/// All calls in a region with corners at circles; the first error that there is.
Error callInRegion(const Diagram& diagram, SiteId id, const Circles& corners) {
  std::vector<double> ring;
  for (const Circle& c : corners) ring.insert(ring.end(), {c.x, c.y});
  const std::vector<std::uint32_t> starts{0, static_cast<std::uint32_t>(corners.size())};
  std::vector<SiteId> ids;
  Region region;
  if (region.assign(ring, starts) != Error::kNone) return diagram.ids(ids);  // nothing is inside
  const Voronoi voronoi(diagram, region);
  const double tolerance = defaultTolerance(region.box());
  CurveArrays curves;
  RingArrays rings;
  CellMeasures measures;
  std::vector<double> all;
  Path path;
  Portion portion;
  Error first = Error::kNone;
  for (const auto& call : std::initializer_list<std::function<Error()>>{
           [&] { return voronoi.edgeCurves(curves); },
           [&] { return voronoi.cellCurves(id, curves); },
           [&] { return voronoi.cellPolygon(id, tolerance, rings); },
           [&] { return voronoi.cellMeasures(id, measures); },
           [&] { return voronoi.cellAreas(all); }, [&] { return voronoi.cellCentroids(all); },
           [&] { return voronoi.cellPerimeters(all); },
           [&] { return voronoi.drawEdges(tolerance, portion, path); },
           [&] { return voronoi.drawCell(id, tolerance, path); }}) {
    const Error error = call();
    if (first == Error::kNone) first = error;
  }
  return first;
}

/// Queries: the next sites of a walk, and the sites at a place and around it.
Error callQueries(const Diagram& diagram, const Circle& a, const Circle& b, bool isSmallest) {
  SiteId id = kNoSite;
  std::vector<SiteId> some;
  NearestFirst walk(diagram);
  Error error = walk.start(a.x, b.y);
  for (int k = 0; k < 20 && error == Error::kNone; ++k) error = walk.next(id);
  if (error == Error::kNone)
    error = diagram.pick(a.x, b.y, 1e9, isSmallest ? Top::kSmallest : Top::kLast, id);
  if (error != Error::kNone) return error;
  return diagram.search(std::min(a.x, b.x), std::min(a.y, b.y), std::max(a.x, b.x),
                        std::max(a.y, b.y), some);
}

/// Two steps, in the box of two circles. (Most boxes are none for these sites.)
Error callFit(const Diagram& diagram, const Circle& a, const Circle& b) {
  Region region;
  const std::vector<double> ring{a.x, a.y, b.x, a.y, b.x, b.y, a.x, b.y};
  std::vector<std::uint8_t> levels;
  Error error = diagram.levels(levels);  // one for each id
  if (error != Error::kNone || region.assign(ring, std::vector<std::uint32_t>{0, 4}) != error)
    return error;
  AreaFit fit;
  error = fit.begin(diagram, region, std::vector<double>(levels.size(), 1));
  if (error != Error::kNone) return error;
  static_cast<void>(fit.step());
  static_cast<void>(fit.step());
  return Error::kNone;
}

}  // namespace

bool callEverything(Diagram& diagram, std::uint64_t seed) {
  Random random(seed);
  bool isBroken = false;
  const auto take = [&](Error error) {
    if (isBroken) return expect(error != Error::kNone, "a broken diagram answers");
    isBroken = error == Error::kCorruptSnapshot;
  };
  std::vector<SiteId> ids;
  take(diagram.ids(ids));
  Circles circles{{1, 2, 3}};
  for (const SiteId id : ids) {
    circles.emplace_back();
    take(diagram.site(id, circles.back()));
  }
  if (isBroken) return true;
  const auto anyId = [&] { return ids.empty() ? SiteId{0} : ids[random.below(ids.size())]; };
  const auto any = [&]() -> const Circle& { return circles[random.below(circles.size())]; };
  const auto between = [&](double a, double b) {
    const double c = random.oneIn(3) ? a : a + (b - a) * random.between(-0.5, 1.5);
    return isInRange(c) ? c : 0.0;
  };
  std::vector<SiteId> some;
  VertexArrays vertices;
  EdgeArrays edges;
  CurveArrays curves;
  RingArrays rings;
  CellMeasures measures;
  std::vector<double> areas;
  std::vector<std::uint8_t> bytes;
  Path path;
  SiteId id = kNoSite;
  double distance = 0;
  bool flag = false;
  std::size_t count = 0;
  for (int step = 0; step < 60; ++step) {
    const Circle a = any(), b = any();
    const double x = between(a.x, b.x), y = between(a.y, b.y), r = between(a.r, b.r);
    const Bounds extent = Voronoi::extentOf(diagram);
    const Voronoi voronoi(diagram, random.oneIn(2) ? extent : Bounds{-100, -100, 100, 100});
    const double tolerance = defaultTolerance(extent);
    Portion portion;
    Violation violation;
    // Reading calls, and one that changes it after a while.
    switch (random.below(step < 20 ? 26u : 34u)) {
      case 0:
      case 1:
      case 2:
        take(diagram.find(x, y, id, distance));
        break;
      case 3:
        take(diagram.kNearest(x, y, 1 + random.below(std::size_t{9}), some));
        break;
      case 4:
        take(diagram.within(x, y, r, some));
        break;
      case 5:
        take(diagram.neighbors(anyId(), some));
        break;
      case 6:
        take(diagram.vertices(vertices));
        break;
      case 7:
        take(diagram.edges(edges));
        break;
      case 8:
        take(diagram.faces(some));
        break;
      case 9:
        take(diagram.coverOf(anyId(), id));
        break;
      case 10:
        take(diagram.validate(violation));
        break;
      case 11:
        take(diagram.toBytes(bytes));
        break;
      case 12:
        take(voronoi.edgeCurves(curves));
        break;
      case 13:
        take(voronoi.cellCurves(anyId(), curves));
        break;
      case 14:
        take(voronoi.cellPolygon(anyId(), tolerance, rings));
        break;
      case 15:
        take(voronoi.cellMeasures(anyId(), measures));
        break;
      case 16:
        take(voronoi.cellMoments(anyId(), measures));
        break;
      case 17:
        take(voronoi.cellAreas(areas));
        break;
      case 18:
        take(diagram.hull(some));
        break;
      case 19:
        take(voronoi.drawEdges(tolerance, portion, path));
        break;
      case 20:
        take(voronoi.drawDual(tolerance, random.oneIn(2), portion, path));
        break;
      case 21:
        take(voronoi.drawHull(tolerance, path)), take(voronoi.drawCell(anyId(), tolerance, path));
        break;
      case 22:
        take(voronoi.cellCentroids(areas)), take(voronoi.cellPerimeters(areas));
        break;
      case 23:
        take(callQueries(diagram, a, b, random.oneIn(2)));
        break;
      case 24: {
        Circles corners{a, b, any(), {x, y, 0}};
        if (random.oneIn(2)) corners.insert(corners.begin() + 1, {a.x, b.y, 0});
        take(callInRegion(diagram, anyId(), corners));
        break;
      }
      case 25:
        take(callFit(diagram, a, b));
        break;
      case 26:
      case 27:
      case 28:
        take(diagram.insert(x, y, r, id));
        break;
      case 29:
        take(diagram.remove(anyId(), flag));
        break;
      case 30:
      case 31:
        take(diagram.update(anyId(), x, y, r));
        break;
      case 32: {
        const std::vector<SiteId> two{anyId(), anyId()};
        const std::vector<double> triples{x, y, r, y, x, r};
        take(diagram.updateMany(two, triples));
        break;
      }
      default: {
        const std::vector<double> triples{x, y, r, y, x, r, a.x, b.y, r};
        std::vector<SiteId> three(3);
        const std::vector<SiteId> gone{anyId(), anyId()};
        take(random.oneIn(2) ? diagram.insertMany(triples, three)
                             : diagram.removeMany(gone, count));
      }
    }
  }
  if (!isBroken) {
    for (const SiteId gone : ids) take(diagram.remove(gone, flag));
  }
  if (isBroken) {
    diagram.clear();
    isBroken = false;
    take(diagram.insert(1, 2, 3, id));
    expect(!isBroken && diagram.size() == 1, "a diagram that was cleared is as new");
    return true;
  }
  return false;
}

}  // namespace apollonius::test
