// libFuzzer target: bytes are circles, some changes, and places. There queries must find what a
// search of all circles finds with the oracle's distances: kNearest, within, NearestFirst, pick,
// search. A diagram that was built in steps must have the bytes of one that was built at once. How
// to run: README.md beside this.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <map>
#include <vector>

#include "apollonius/builder.h"
#include "apollonius/nearest_first.h"
#include "support/circles_of_bytes.h"
#include "support/oracle.h"

namespace apollonius::test {
namespace {

constexpr double kAnywhere = std::numeric_limits<double>::infinity();

double legal(double value) { return isInRange(value) ? value : 0; }

class Checker {
 public:
  explicit Checker(Bytes& bytes) : bytes_(bytes) {
    const Circles circles = circlesOf(bytes);
    const std::vector<double> xyr = flat(circles);
    std::vector<SiteId> ids(circles.size());
    take(diagram_.insertMany(xyr, ids));
    for (SiteId id = 0; id < ids.size(); ++id) circles_[id] = circles[id];
    checkBuilder(xyr);
  }

  void run() {
    for (int k = 0; k < 8 && !bytes_.empty(); ++k) {
      change();
      checkAt(place(true), place(false));
    }
  }

 private:
  [[noreturn]] void fail(const char* what) const {
    std::fprintf(stderr, "%s\n", what);
    for (const auto& [id, c] : circles_) std::fprintf(stderr, "insert %a %a %a\n", c.x, c.y, c.r);
    std::abort();
  }
  void take(Error error) const {
    if (error != Error::kNone) fail("an error");
  }
  void expect(bool condition, const char* what) const {
    if (!condition) fail(what);
  }

  void checkBuilder(const std::vector<double>& xyr) const {
    Diagram built;
    {
      Builder builder(built);
      take(builder.add(xyr));
      const std::size_t steps = bytes_.next() % 8 + 1u;
      for (bool isDone = false; !isDone;) take(builder.advance(steps, isDone));
    }
    std::vector<std::uint8_t> whole, inSteps;
    take(diagram_.toBytes(whole));
    take(built.toBytes(inSteps));
    expect(whole == inSteps, "built in steps it is another");
  }

  /// Removes or moves one circle.
  void change() {
    const std::uint8_t code = bytes_.next();
    if (circles_.empty() || code % 4 > 1) return;
    const SiteId id = any();
    bool removed = false;
    if (code % 4 == 0) {
      take(diagram_.remove(id, removed));
      circles_.erase(id);
    } else {
      const Circle to{place(true), place(false), circles_[any()].r};
      take(diagram_.update(id, to.x, to.y, to.r));
      circles_[id] = to;
    }
  }

  SiteId any() const {
    return std::next(circles_.begin(), bytes_.next() % std::ptrdiff_t(circles_.size()))->first;
  }

  /// A number of a circle's, a rim's, or in between.
  double place(bool isX) const {
    if (circles_.empty()) return static_cast<std::int8_t>(bytes_.next());
    const Circle &a = circles_.at(any()), &b = circles_.at(any());
    const double p = isX ? a.x : a.y, q = isX ? b.x : b.y;
    const double choices[]{p, p + a.r, p - b.r, (p + q) / 2, 2 * p - q, q + (bytes_.next() - 128)};
    return legal(choices[bytes_.next() % 6]);
  }

  std::vector<SiteId> sortedAt(double x, double y) const {
    std::vector<SiteId> ids;
    for (const auto& [id, circle] : circles_) ids.push_back(id);
    std::stable_sort(ids.begin(), ids.end(), [&](SiteId a, SiteId b) {
      const Circle &s = circles_.at(a), &t = circles_.at(b);
      const int sign = oracleCompareDistance(x, y, s, t);
      return sign < 0 || (sign == 0 && oracleSmaller(t, s));
    });
    return ids;
  }

  bool isWithin(SiteId id, double x, double y, double distance) const {
    return oracleCompareDistance(x, y, circles_.at(id), {x, y, -distance}) <= 0;
  }

  void expectSame(const std::vector<SiteId>& got, const std::vector<SiteId>& expected,
                  const char* what) const {
    expect(got.size() == expected.size(), what);
    for (std::size_t k = 0; k < got.size(); ++k) expect(got[k] == expected[k], what);
  }

  void checkAt(double x, double y) const {
    const std::vector<SiteId> all = sortedAt(x, y);
    const auto first = [&](auto&& isIn) {
      std::vector<SiteId> ids;
      std::copy_if(all.begin(), all.end(), std::back_inserter(ids), isIn);
      return ids;
    };
    std::vector<SiteId> got;
    const std::size_t k = bytes_.next() % 8;
    take(diagram_.kNearest(x, y, k, got));
    expectSame(got, {all.begin(), all.begin() + std::ptrdiff_t(std::min(k, all.size()))},
               "kNearest");

    const double distance = circles_.empty() ? 1 : legal(circles_.at(any()).x - x);
    const auto near = first([&](SiteId id) { return isWithin(id, x, y, distance); });
    take(diagram_.within(x, y, distance, got));
    expectSame(got, near, "within");
    NearestFirst walk(diagram_);
    take(walk.start(x, y, distance));
    for (const SiteId expected : got) {
      SiteId id = kNoSite;
      take(walk.next(id));
      expect(id == expected, "NearestFirst");
    }

    const double low = legal(std::min(x, distance)), high = legal(std::max(x, distance));
    const double top = legal(y + std::abs(distance));
    take(diagram_.search(low, y, high, std::max(y, top), got));
    std::vector<SiteId> meeting;
    for (const auto& [id, c] : circles_) {
      if (isWithin(id, std::clamp(c.x, low, high), std::clamp(c.y, y, std::max(y, top)), 0))
        meeting.push_back(id);
    }
    expect(got == meeting, "search");
    checkPick(x, y, all);
  }

  void checkPick(double x, double y, const std::vector<SiteId>& all) const {
    SiteId smallest = kNoSite, last = kNoSite;
    for (const SiteId id : all) {
      if (!isWithin(id, x, y, 0)) break;
      last = last == kNoSite ? id : std::max(id, last);
      if (smallest == kNoSite || circles_.at(id).r < circles_.at(smallest).r) smallest = id;
    }
    SiteId id = kNoSite;
    take(diagram_.pick(x, y, kAnywhere, Top::kLast, id));
    if (last != kNoSite) {
      expect(id == last, "pick, the last");
      take(diagram_.pick(x, y, 0, Top::kSmallest, id));
      expect(id == smallest, "pick, the smallest");
      return;
    }
    expect(all.empty() == (id == kNoSite), "pick");
    if (!all.empty()) expect(id == all[0], "pick, the nearest");
    take(diagram_.pick(x, y, 0, Top::kLast, id));
    expect(id == kNoSite, "pick, none");
  }

  Bytes& bytes_;
  std::map<SiteId, Circle> circles_;
  Diagram diagram_;
};

}  // namespace
}  // namespace apollonius::test

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  apollonius::test::Bytes bytes({data, size});
  apollonius::test::Checker(bytes).run();
  return 0;
}
