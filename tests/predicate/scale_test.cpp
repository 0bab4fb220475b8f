// A hundred thousand predicate calls of all families, each stage against the exact one: the short
// version of tests/scale/predicate_scale.cpp.
#include <gtest/gtest.h>

#include "support/effort.h"
#include "support/scale_run.h"

namespace apollonius::test {
namespace {

TEST(Scale, NoStageContradictsTheExactOne) {
  ScaleRun run(1);
  while (run.calls() < static_cast<std::uint64_t>(runs(sized(25000, 100000)))) run.round();
  EXPECT_EQ(run.disagreements(), 0u) << run.report();
}

}  // namespace
}  // namespace apollonius::test
