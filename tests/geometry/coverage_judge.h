// Judges polygons of all cells, for tests and fuzzers.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "apollonius/voronoi.h"
#include "predicate/orientation.h"

namespace apollonius::test {

using Place = std::pair<double, double>;

/// Says what is wrong with the polygons of all cells; empty if nothing is. `area` is that of all
/// together, or 0 if it is not known.
class CoverageJudge {
 public:
  explicit CoverageJudge(const CoverageArrays& coverage, double area) {
    for (std::size_t cell = 0; cell < coverage.sites.size(); ++cell) {
      for (std::size_t part = coverage.cells[cell]; part < coverage.cells[cell + 1]; ++part) {
        for (std::size_t ring = coverage.parts[part]; ring < coverage.parts[part + 1]; ++ring)
          addRing(coverage, ring, coverage.sites[cell], ring > coverage.parts[part]);
      }
    }
    if (area != 0 && !coverage.sites.empty() && !(std::abs(sum_ / area - 1) <= 1e-9))
      complain() << "areas add up to " << sum_ << " of " << area;
  }

  /// Expects that every segment has its reverse in another cell, or satisfies the condition.
  template <class IsOnBorder>
  void expectPairs(IsOnBorder&& isOnBorder) {
    for (const auto& [ends, site] : segments_) {
      const auto back = segments_.find({ends.second, ends.first});
      if (back == segments_.end() ? !isOnBorder(ends.first, ends.second) : back->second == site)
        complain() << "site " << site << " has a side of its own: " << textOf(ends);
    }
  }

  void expectNoCrossings() {
    std::vector<std::pair<Place, Place>> lines;
    for (const auto& [ends, site] : segments_) lines.push_back(ends);
    for (std::size_t k = 0; k < lines.size(); ++k) {
      for (std::size_t m = 0; m < k; ++m) {
        const auto& [a, b] = lines[k];
        const auto& [c, d] = lines[m];
        if (std::max(a.first, b.first) < std::min(c.first, d.first) ||
            std::max(c.first, d.first) < std::min(a.first, b.first))
          continue;
        const auto turn = [](Place p, Place q, Place r) {
          return internal::orient2d({p.first, p.second}, {q.first, q.second}, {r.first, r.second});
        };
        const auto areApart = [](internal::Sign s, internal::Sign t) {
          return s * t == internal::Sign::kNegative;
        };
        if (areApart(turn(a, b, c), turn(a, b, d)) && areApart(turn(c, d, a), turn(c, d, b)))
          complain() << textOf(lines[k]) << " crosses " << textOf(lines[m]);
      }
    }
  }

  [[nodiscard]] std::string complaints() const { return text_.str(); }

 private:
  void addRing(const CoverageArrays& coverage, std::size_t ring, SiteId site, bool isHole) {
    std::set<Place> points;
    double area = 0;
    const auto at = [&](std::size_t k) {
      return Place{coverage.coordinates[2 * k], coverage.coordinates[2 * k + 1]};
    };
    const std::size_t first = coverage.starts[ring], end = coverage.starts[ring + 1];
    for (std::size_t k = first; k + 1 < end; ++k) {
      const Place p = at(k), q = at(k + 1);
      if (!points.insert(p).second) complain() << "site " << site << " has a point twice";
      if (!segments_.emplace(std::pair(p, q), site).second)
        complain() << "a segment stands twice, in site " << site;
      const Place origin = at(first);
      area += (p.first - origin.first) * (q.second - origin.second) -
              (q.first - origin.first) * (p.second - origin.second);
    }
    if (points.size() < 3 || at(first) != at(end - 1))
      complain() << "site " << site << " has an invalid ring";
    if (isHole ? area > 0 : area < 0) complain() << "site " << site << " has a ring that is turned";
    sum_ += area / 2;
  }

  std::ostringstream& complain() {
    text_.precision(17);
    text_ << "\n";
    return text_;
  }
  static std::string textOf(const std::pair<Place, Place>& ends) {
    std::ostringstream text;
    text.precision(17);
    text << ends.first.first << " " << ends.first.second << " to " << ends.second.first << " "
         << ends.second.second;
    return text.str();
  }

  double sum_ = 0;
  std::map<std::pair<Place, Place>, SiteId> segments_;
  std::ostringstream text_;
};

/// Rounding of points on the border, as a share of the window's largest coordinate.
inline constexpr double kCoverageRounding = 1e-11;

inline double sizeOf(const Bounds& b) {
  return std::max({std::abs(b.xmin), std::abs(b.ymin), std::abs(b.xmax), std::abs(b.ymax)});
}

/// Says what is wrong with polygons that are to tile a rectangle; empty if nothing is.
inline std::string faultsOf(const CoverageArrays& coverage, const Bounds& bounds) {
  CoverageJudge judge(coverage, (bounds.xmax - bounds.xmin) * (bounds.ymax - bounds.ymin));
  const double rounding = kCoverageRounding * sizeOf(bounds);
  judge.expectPairs([&](Place p, Place q) {
    const auto areOn = [&](double side, double a, double b) {
      return std::abs(a - side) <= rounding && std::abs(b - side) <= rounding;
    };
    return areOn(bounds.xmin, p.first, q.first) || areOn(bounds.xmax, p.first, q.first) ||
           areOn(bounds.ymin, p.second, q.second) || areOn(bounds.ymax, p.second, q.second);
  });
  judge.expectNoCrossings();
  return judge.complaints();
}

}  // namespace apollonius::test
