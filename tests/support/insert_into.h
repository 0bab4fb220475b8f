// Puts circles into a diagram in one call.
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "apollonius/diagram.h"
#include "support/generators.h"

namespace apollonius::test {

/// Their ids, in the same order.
inline std::vector<SiteId> insertInto(Diagram& diagram, const Circles& circles) {
  std::vector<double> xyr;
  for (const Circle& c : circles) xyr.insert(xyr.end(), {c.x, c.y, c.r});
  std::vector<SiteId> ids(circles.size());
  EXPECT_EQ(diagram.insertMany(xyr, ids), Error::kNone);
  return ids;
}

}  // namespace apollonius::test
