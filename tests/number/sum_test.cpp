// A sum that keeps what rounding loses of it.
#include "number/sum.h"

#include <gtest/gtest.h>

namespace apollonius::internal {
namespace {

double sumOf(std::initializer_list<double> terms) {
  Sum sum;
  for (const double term : terms) sum.add(term);
  return sum.value();
}

TEST(Sum, KeepsSmallTermsBesideLargeOnes) {
  EXPECT_EQ(sumOf({1, 1e100, 1, -1e100}), 2);
  EXPECT_EQ(sumOf({1e100, 1, -1e100, 1}), 2);
  EXPECT_EQ(sumOf({0x1p53, 1, 1, 1, -0x1p53}), 3);
  EXPECT_EQ(sumOf({}), 0);
}

}  // namespace
}  // namespace apollonius::internal
