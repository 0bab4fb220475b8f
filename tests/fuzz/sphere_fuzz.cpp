// libFuzzer target: bytes are read as a sequence of operations on a SphericalDiagram: single ones,
// batches, sets that a generator draws, snapshots, sound ones and false ones. Centres are mostly of
// lattices of whole degrees, with poles, the antimeridian, duplicates and antipodes, and many
// weights hide other sites. After each call validate() runs, and queries, areas and polygons are
// compared with brute force over all sites. A failure prints the history. How to run: README.md
// beside this file.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <map>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include "base/byte_stream.h"
#include "sphere/projection.h"
#include "sphere/sphere_sets.h"
#include "support/bytes.h"

namespace apollonius::test {
namespace {

constexpr std::size_t kMostCalls = 40;
constexpr std::size_t kMostSites = 160;

/// Ways to make centres of bytes.
enum class Centres : std::uint8_t { kThirtyDegrees, kFifteenDegrees, kBesideLattice, kDoubles };

class Checker {
 public:
  explicit Checker(Bytes& bytes) : bytes_(bytes) {
    const std::uint8_t mode = bytes_.next();
    centres_ = static_cast<Centres>(mode & 3);
    constexpr double kRadii[] = {1, 6371.0088, 1, 0x1p-20};
    radius_ = kRadii[mode >> 2 & 3];
    diagram_ = SphericalDiagram(radius_);
  }

  void run() {
    for (std::size_t call = 0; !bytes_.empty() && call < kMostCalls; ++call) {
      step(bytes_.next());
      check();
    }
    checkCells();
  }

 private:
  // --- What bytes say

  SphericalPoint point() {
    const int x = bytes_.next() % 25 - 12, y = bytes_.next() % 13 - 6;
    const auto aside = [&] {  // from 2^-47 degrees to half of one
      const std::uint8_t how = bytes_.next();
      return how == 0 ? 0 : std::ldexp(how % 2 == 0 ? 1.0 : -1.0, -(how / 2 % 47) - 1);
    };
    switch (centres_) {
      case Centres::kThirtyDegrees:
        return {30.0 * (x / 2), 30.0 * (y / 2)};
      case Centres::kFifteenDegrees:
        return {15.0 * x, 15.0 * y};
      case Centres::kBesideLattice: {
        const double lon = 30.0 * (x / 2) + aside();
        return {lon, std::clamp(30.0 * (y / 2) + aside(), -90.0, 90.0)};
      }
      case Centres::kDoubles:
        break;
    }
    const auto number = [&] { return static_cast<double>(bytes_.next64() >> 11) * 0x1p-52 - 1; };
    const double lon = 180 * number();
    return {lon, 90 * number()};
  }

  /// A weight in radians. Lattice points are at multiples of 15 degrees, so that some touch from
  /// inside.
  double weight() {
    constexpr double kPi = std::numbers::pi;
    constexpr double kWeights[] = {0,   0,    0.1,  0.25,  kPi / 12, kPi / 6, 1,       kPi / 2,
                                   2.5, 3.14, -0.5, -3.14, 1e-300,   1e-9,    kPi / 3, 5 * kPi / 6};
    const std::uint8_t code = bytes_.next();
    return code < 192 ? kWeights[code % 16] : code / 256.0;
  }

  /// Somewhere, or at a site, or opposite of one.
  SphericalPoint place() {
    const std::uint8_t code = bytes_.next();
    if (sites_.empty() || code % 4 > 1) return point();
    const SphericalCircle& site = sites_.at(any());
    if (code % 4 == 0) return {site.lon, site.lat};
    return {site.lon > 0 ? site.lon - 180 : site.lon + 180, -site.lat};
  }

  SphericalCircle circle() {
    const SphericalPoint centre = place();
    return {centre.lon, centre.lat, weight() * radius_};
  }

  SiteId any() {
    return std::next(sites_.begin(), bytes_.next() % std::ptrdiff_t(sites_.size()))->first;
  }

  // --- Calls

  void step(std::uint8_t code) {
    const std::size_t more = code / 16 + 1u;
    switch (code % 16) {
      case 5:
        insertMany(circles(more));
        return;
      case 6:
        insertSet(more);
        return;
      case 7:
      case 8:
        remove();
        return;
      case 9:
        removeMany(more);
        return;
      case 10:
      case 11:
        update();
        return;
      case 12:
        updateMany(more);
        return;
      case 13:
        restore();
        return;
      case 14:
        restoreFalse();
        return;
      case 15:
        checkCells();
        return;
      default:
        insert(circle());
    }
  }

  SphericalSites circles(std::size_t count) {
    SphericalSites sites;
    for (std::size_t k = 0; k < count; ++k) sites.push_back(circle());
    return sites;
  }

  void note(const char* what, SiteId id, const SphericalCircle& site) {
    char line[160];
    std::snprintf(line, sizeof line, "%s %u: {%.17g, %.17g, %.17g}\n", what, id, site.lon, site.lat,
                  site.r);
    addLine(line);
  }
  void addLine(const char* line) {
#ifdef APOLLONIUS_FUZZ_PRINT
    std::fputs(line, stderr);
#endif
    history_ += line;
  }

  void insert(const SphericalCircle& site) {
    if (sites_.size() >= kMostSites) return;
    note("insert", static_cast<SiteId>(sites_.size()), site);
    SiteId id = kNoSite;
    take(diagram_.insert(site.lon, site.lat, site.r, id));
    expect(sites_.emplace(id, site).second, "an id twice");
  }

  void insertMany(const SphericalSites& more) {
    if (sites_.size() + more.size() > kMostSites) return;
    for (const SphericalCircle& site : more)
      note("insertMany", static_cast<SiteId>(sites_.size()), site);
    std::vector<SiteId> ids(more.size());
    take(diagram_.insertMany(flat(more), ids));
    for (std::size_t k = 0; k < ids.size(); ++k)
      expect(sites_.emplace(ids[k], more[k]).second, "an id twice");
  }

  void insertSet(std::size_t size) {
    Random random(bytes_.next());
    SphericalSites more = randomSites(random, 5 * size, weight());
    for (SphericalCircle& site : more) site.r *= radius_;
    insertMany(more);
  }

  void remove() {
    if (sites_.empty()) return;
    const SiteId id = any();
    note("remove", id, sites_.at(id));
    bool removed = false;
    take(diagram_.remove(id, removed));
    expect(removed, "remove");
    sites_.erase(id);
  }

  void removeMany(std::size_t count) {
    std::vector<SiteId> ids = {12345};
    std::size_t removed = 0, expected = 0;
    while (count-- > 0 && !sites_.empty()) {
      ids.push_back(any());
      note("removeMany", ids.back(), sites_.at(ids.back()));
      expected += sites_.erase(ids.back());
      ids.push_back(ids.back());
    }
    take(diagram_.removeMany(ids, removed));
    expect(removed == expected, "removeMany");
  }

  void update() {
    if (sites_.empty()) return;
    const SiteId id = any();
    const SphericalCircle site = circle();
    note("update", id, site);
    take(diagram_.update(id, site.lon, site.lat, site.r));
    sites_[id] = site;
  }

  void updateMany(std::size_t count) {
    std::vector<SiteId> ids;
    SphericalSites moved;
    for (; count > 0 && !sites_.empty(); --count) {
      ids.push_back(any());
      moved.push_back(circle());
      note("updateMany", ids.back(), moved.back());
    }
    take(diagram_.updateMany(ids, flat(moved)));
    for (std::size_t k = 0; k < ids.size(); ++k) sites_[ids[k]] = moved[k];
  }

  void restore() {
    addLine("restore\n");
    std::vector<std::uint8_t> bytes, again;
    take(diagram_.toBytes(bytes));
    SphericalDiagram restored;
    take(restored.fromBytes(bytes));
    take(restored.toBytes(again));
    expect(bytes == again, "restored it has other bytes");
    expect(restored.radius() == radius_, "restored it has another radius");
    diagram_ = std::move(restored);
  }

  /// Restores changed bytes with the right checksum: refused, or a sound diagram.
  void restoreFalse() {
    std::vector<std::uint8_t> bytes;
    take(diagram_.toBytes(bytes));
    const std::size_t size = bytes.size() - 8;
    for (int k = bytes_.next() % 4; k >= 0; --k) {
      const std::size_t at = bytes_.next() + 256u * (bytes_.next() % 16);
      bytes[at % size] = bytes_.next();
    }
    const std::uint64_t sum = internal::checksumOf({bytes.data(), size});
    for (unsigned k = 0; k < 8; ++k) bytes[size + k] = static_cast<std::uint8_t>(sum >> (8 * k));
    SphericalDiagram restored;
    const Error error = restored.fromBytes(bytes);
    if (error == Error::kCorruptSnapshot) return;
    take(error);
    Violation violation;
    take(restored.validate(violation));
    expect(!violation.isFound(), "of a false snapshot: " + violation.text());
  }

  // --- Checks

  [[noreturn]] void fail(const std::string& what) const {
    std::fprintf(stderr, "%s\nradius %.17g\n%s", what.c_str(), radius_, history_.c_str());
    for (const auto& [id, site] : sites_)
      std::fprintf(stderr, "site %u: {%.17g, %.17g, %.17g}\n", id, site.lon, site.lat, site.r);
    std::abort();
  }
  void take(Error error) const {
    if (error != Error::kNone) fail("an error");
  }
  void expect(bool condition, const std::string& what) const {
    if (!condition) fail(what);
  }

  /// Distance on the unit sphere.
  [[nodiscard]] double distanceFrom(const SphericalPoint& p, SiteId id) const {
    const SphericalCircle& site = sites_.at(id);
    return distanceOf(p, {site.lon, site.lat, site.r / radius_});
  }

  void check() {
    Violation violation;
    take(diagram_.validate(violation));
    expect(!violation.isFound(), violation.text());
    expect(diagram_.size() == sites_.size(), "size");
    std::vector<SiteId> ids, mine;
    take(diagram_.ids(ids));
    for (const auto& [id, site] : sites_) mine.push_back(id);
    expect(ids == mine, "ids");
    for (int k = 0; k < 2; ++k) checkAt(place());
    if (sites_.empty()) return;
    checkSite(any());
  }

  /// Twice the rounding of sites as they are seen from the pole, which a snapshot tells
  /// (sphere/nearest.cpp); and that of distances.
  [[nodiscard]] double toleranceOfFind() const {
    std::vector<std::uint8_t> snapshot;
    take(diagram_.toBytes(snapshot));
    constexpr std::size_t kPole = 20;
    const SiteId pole = internal::WordReader(std::span(snapshot).subspan(kPole)).word();
    const auto capOf = [&](const SphericalCircle& site) {
      return internal::sphere::capOf({site.lon, site.lat}, site.r / radius_);
    };
    const internal::sphere::Projection projection(capOf(sites_.at(pole)));
    double loss = 1;
    for (const auto& [id, site] : sites_) {
      const auto image = projection.image(capOf(site));
      if (image.kind == internal::sphere::Projection::Kind::kCircle)
        loss = std::max(loss, image.loss);
    }
    return 8 * loss * 0x1p-53 + 4e-15;
  }

  void checkAt(const SphericalPoint& p) {
    std::vector<double> distances;
    for (const auto& [id, site] : sites_) distances.push_back(distanceFrom(p, id));
    std::ranges::sort(distances);
    SiteId id = kNoSite;
    double distance = 0;
    take(diagram_.find(p.lon, p.lat, id, distance));
    expect((id == kNoSite) == sites_.empty(), "find in an empty diagram");
    if (id == kNoSite) return;
    expect(distanceFrom(p, id) <= distances[0] + toleranceOfFind(), "find");
    expect(std::abs(distance / radius_ - distances[0]) < kRounding, "the distance of find");
    bool isInside = false;
    take(diagram_.contains(id, p.lon, p.lat, kEverywhere, isInside));
    expect(isInside, "contains");
    std::vector<SiteId> got;
    const std::size_t k = bytes_.next() % 16;
    take(diagram_.kNearest(p.lon, p.lat, k, std::numeric_limits<double>::infinity(), got));
    expect(got.size() == std::min(k, sites_.size()), "the number of kNearest");
    for (std::size_t n = 0; n < got.size(); ++n)
      expect(std::abs(distanceFrom(p, got[n]) - distances[n]) < kRounding, "kNearest");
  }

  /// Hidden sites are those that another covers.
  void checkSite(SiteId id) {
    const SphericalCircle& site = sites_.at(id);
    const auto isCoveredBy = [&](SiteId other, double rounding) {
      return distanceFrom({site.lon, site.lat}, other) <= -site.r / radius_ + rounding;
    };
    bool isHidden = false;
    SiteId cover = kNoSite;
    take(diagram_.isHidden(id, isHidden));
    take(diagram_.coverOf(id, cover));
    expect(isHidden == (cover != kNoSite), "coverOf");
    if (isHidden) {
      expect(cover != id && isCoveredBy(cover, kOfCover), "the cover covers no site");
      return;
    }
    for (const auto& [other, circle] : sites_)
      expect(other == id || !isCoveredBy(other, -kOfCover), "a covered site is not hidden");
  }

  void checkCells() {
    addLine("cells\n");
    if (sites_.empty()) return;
    const std::size_t h = diagram_.visibleSize();
    VertexArrays vertices;
    take(diagram_.vertices(vertices));
    expect(vertices.clearance.size() == (h < 3 ? 0 : 2 * h - 4), "the number of vertices");
    EdgeArrays edges;
    take(diagram_.edges(edges));
    expect(edges.sites.size() / 2 == (h < 2 ? 0 : h == 2 ? 1 : 3 * h - 6), "the number of edges");
    std::vector<double> areas;
    take(diagram_.cellAreas({}, areas));
    double sum = 0;
    for (const double area : areas) {
      expect(area >= 0, "an area");
      sum += area / (radius_ * radius_);
    }
    expect(hasClosePair() || std::abs(sum / (4 * std::numbers::pi) - 1) < kOfAreas,
           "areas add up to " + std::to_string(sum));
    constexpr double kTolerances[] = {0.3, 0.03, 1e-3};
    CoverageArrays polygons;
    take(diagram_.cellPolygons(kTolerances[bytes_.next() % 3], true, {}, polygons));
    expect(polygons.sites.size() == h, "the number of polygons");
    checkRectangle(polygons);
    checkReach(areas, kTolerances[bytes_.next() % 3]);
    checkNaturalWeights();
  }

  /// Cells that end at a distance are parts of cells, with as few points.
  void checkReach(const std::vector<double>& whole, double tolerance) {
    const double angle = (bytes_.next() - 16) / 64.0;
    addLine(("within " + std::to_string(angle) + "\n").c_str());
    const double distance[] = {angle * radius_};
    std::vector<double> areas, perimeters;
    take(diagram_.cellAreas(distance, areas));
    take(diagram_.cellPerimeters(distance, perimeters));
    for (std::size_t id = 0; id < areas.size(); ++id) {
      const double area = areas[id] / (radius_ * radius_);
      expect(area >= 0 && area <= whole[id] / (radius_ * radius_) + kOfAreas, "an area within");
      expect(perimeters[id] >= 0 && perimeters[id] < 100 * radius_, "a perimeter within");
    }
    for (const bool isCut : {false, true}) {
      CoverageArrays polygons;
      take(diagram_.cellPolygons(tolerance, isCut, distance, polygons));
      expect(polygons.coordinates.size() < 20000 * sites_.size(), "the number of points within");
    }
  }

  void checkNaturalWeights() {
    const double lon = bytes_.next() * 1.5 - 180, lat = bytes_.next() * 0.7 - 89;
    addLine(
        ("natural weights at " + std::to_string(lon) + " " + std::to_string(lat) + "\n").c_str());
    NaturalWeights found;
    take(diagram_.naturalWeights(lon, lat, 0, found));
    double sum = 0;
    for (const double weight : found.weights) {
      expect(weight > 0, "a weight");
      sum += weight;
    }
    expect(std::abs(sum - 1) < 1e-12, "weights add up to " + std::to_string(sum));
  }

  /// Are two sites equal up to rounding, or does one touch another from inside? Then their cells
  /// are thinner than rounding, which decides where they end.
  [[nodiscard]] bool hasClosePair() const {
    constexpr double kClose = 1e-12;
    for (const auto& [id, a] : sites_) {
      for (const auto& [other, b] : sites_) {
        const double apart = angleOf(a, b), difference = std::abs(a.r - b.r) / radius_;
        const bool isOther = a.lon != b.lon || a.lat != b.lat;
        if (isOther && (apart < kClose || std::abs(apart - difference) < kClose)) return true;
      }
    }
    return false;
  }

  /// Parts of the rectangle that is all longitudes and latitudes. (In degenerate position slivers
  /// may be turned, or touch themselves.)
  void checkRectangle(const CoverageArrays& polygons) const {
    double sum = 0;
    for (std::size_t ring = 0; ring + 1 < polygons.starts.size(); ++ring) {
      const std::size_t first = polygons.starts[ring], last = polygons.starts[ring + 1] - 1u;
      const auto lon = [&](std::size_t k) { return polygons.coordinates[2 * k]; };
      const auto lat = [&](std::size_t k) { return polygons.coordinates[2 * k + 1]; };
      expect(last >= first + 3, "a ring of two points");
      expect(lon(first) == lon(last) && lat(first) == lat(last), "a ring is open");
      for (std::size_t k = first; k < last; ++k) {
        expect(std::abs(lon(k)) <= 180 && std::abs(lat(k)) <= 90, "a point out of the rectangle");
        expect(lon(k) != lon(k + 1) || lat(k) != lat(k + 1), "a point twice in a row");
        sum += (lon(k) - lon(k + 1)) * (lat(k) + lat(k + 1)) / 2;
      }
    }
    expect(hasClosePair() || std::abs(sum / (360.0 * 180) - 1) < kOfAreas,
           "areas of polygons add up to " + std::to_string(sum));
  }

  static constexpr double kRounding = 1e-13, kOfCover = 1e-12, kOfAreas = 1e-6;

  Bytes& bytes_;
  Centres centres_ = Centres::kDoubles;
  double radius_ = 1;
  std::map<SiteId, SphericalCircle> sites_;
  SphericalDiagram diagram_;
  std::string history_;
};

}  // namespace
}  // namespace apollonius::test

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  apollonius::test::Bytes bytes({data, size});
  apollonius::test::Checker(bytes).run();
  return 0;
}
