// What a user can see of a diagram, to be compared before and after.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "apollonius/diagram.h"
#include "support/generators.h"

namespace apollonius::test {

/// Which of several identical circles is the visible one is not part of it.
struct State {
  std::vector<SiteId> ids;
  Circles circles;
  std::vector<std::pair<std::size_t, bool>>
      hidden;  // a circle (its first position) and whether it is hidden; sorted
  std::vector<std::array<std::size_t, 3>> faces;  // circles, the smallest first; sorted
  std::string broken;

  explicit State(const Diagram& diagram) {
    EXPECT_EQ(diagram.ids(ids), Error::kNone);
    for (const SiteId id : ids) {
      Circle circle{};
      bool isHidden = false;
      EXPECT_EQ(diagram.site(id, circle), Error::kNone);
      EXPECT_EQ(diagram.isHidden(id, isHidden), Error::kNone);
      circles.push_back(circle);
      hidden.emplace_back(positionOf(id), isHidden);
    }
    std::sort(hidden.begin(), hidden.end());
    std::vector<SiteId> corners;
    EXPECT_EQ(diagram.faces(corners), Error::kNone);
    for (std::size_t k = 0; k < corners.size(); k += 3) {
      std::array<std::size_t, 3> face{positionOf(corners[k]), positionOf(corners[k + 1]),
                                      positionOf(corners[k + 2])};
      std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
      faces.push_back(face);
    }
    std::sort(faces.begin(), faces.end());
    EXPECT_EQ(diagram.validate(broken), Error::kNone);
  }

  bool operator==(const State& other) const {
    return ids == other.ids && hidden == other.hidden && faces == other.faces &&
           broken == other.broken &&
           std::equal(circles.begin(), circles.end(), other.circles.begin(), other.circles.end(),
                      same);
  }

 private:
  static bool same(const Circle& a, const Circle& b) {
    return a.x == b.x && a.y == b.y && a.r == b.r;
  }

  /// The position in `circles` of the first circle that is identical to that of id.
  [[nodiscard]] std::size_t positionOf(SiteId id) const {
    if (id == kNoSite) return kNoSite;
    const auto at =
        static_cast<std::size_t>(std::lower_bound(ids.begin(), ids.end(), id) - ids.begin());
    const auto first = std::find_if(circles.begin(), circles.end(),
                                    [&](const Circle& c) { return same(c, circles[at]); });
    return static_cast<std::size_t>(first - circles.begin());
  }
};

}  // namespace apollonius::test
