// Puts circles into a diagram in one call.
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "apollonius/diagram.h"
#include "support/generators.h"

namespace apollonius::test {

/// Their ids, in the same order.
inline std::vector<SiteId> insertInto(Diagram& diagram, const Circles& circles) {
  const std::vector<double> xyr = flat(circles);
  std::vector<SiteId> ids(circles.size());
  EXPECT_EQ(diagram.insertMany(xyr, ids), Error::kNone);
  return ids;
}

}  // namespace apollonius::test
