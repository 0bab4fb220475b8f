// The state of a diagram that a user can see, to be compared before and after.
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

struct State {
  std::vector<SiteId> ids;
  Circles circles;
  std::vector<bool> hidden;
  std::vector<std::array<SiteId, 3>> faces;  // the smallest id first; sorted
  std::string broken;

  explicit State(const Diagram& diagram) {
    EXPECT_EQ(diagram.ids(ids), Error::kNone);
    for (const SiteId id : ids) {
      Circle circle{};
      bool isHidden = false;
      EXPECT_EQ(diagram.site(id, circle), Error::kNone);
      EXPECT_EQ(diagram.isHidden(id, isHidden), Error::kNone);
      circles.push_back(circle);
      hidden.push_back(isHidden);
    }
    std::vector<SiteId> corners;
    EXPECT_EQ(diagram.faces(corners), Error::kNone);
    for (std::size_t k = 0; k < corners.size(); k += 3) {
      std::array<SiteId, 3> face{corners[k], corners[k + 1], corners[k + 2]};
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
};

}  // namespace apollonius::test
