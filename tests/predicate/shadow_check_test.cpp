// The shadow check (predicate/shadow_check.h) compares as many answers as it is set to.
#include "predicate/shadow_check.h"

#include <gtest/gtest.h>

#include <utility>

#include "number/approx.h"
#include "number/sign.h"
#include "support/shadow.h"

namespace apollonius::test {
namespace {

using internal::MaybeSign;
using internal::shadowCheck;
using internal::Sign;

class ShadowCheck : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!internal::kShadowCheck) GTEST_SKIP() << "a build without the shadow check";
    internal::answersSinceShadowCheck = 0;
  }

  const MaybeSign answer_{Sign::kPositive, true};
  int compared_ = 0;
};

TEST_F(ShadowCheck, ComparesEachOrOneOfSevenOrNone) {
  const auto exact = [&] {
    ++compared_;
    return Sign::kPositive;
  };
  for (const auto& [every, expected] : {std::pair{1u, 70}, std::pair{7u, 10}, std::pair{0u, 0}}) {
    const ShadowCheckOf shadow(every);
    compared_ = 0;
    for (int k = 0; k < 70; ++k) shadowCheck(answer_, exact);
    EXPECT_EQ(compared_, expected) << every;
    shadowCheck({Sign::kPositive, false}, exact);  // not known: nothing to compare
    EXPECT_EQ(compared_, expected) << every;
  }
}

#if GTEST_HAS_DEATH_TEST
TEST_F(ShadowCheck, EndsTheProgramAtAContradiction) {
  const ShadowCheckOf each(1);
  EXPECT_DEATH(shadowCheck(answer_, [] { return Sign::kZero; }), "contradicts the exact stage");
}
#endif

}  // namespace
}  // namespace apollonius::test
