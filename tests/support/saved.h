// A diagram's snapshot: to be compared, and to be read again.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "apollonius/diagram.h"

namespace apollonius::test {

/// Returns the snapshot of a diagram of the plane or the sphere.
template <typename Diagram>
std::vector<std::uint8_t> saved(const Diagram& diagram) {
  std::vector<std::uint8_t> bytes;
  EXPECT_EQ(diagram.toBytes(bytes), Error::kNone);
  return bytes;
}

}  // namespace apollonius::test
