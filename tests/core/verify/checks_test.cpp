// Every check of `abstand verify` passes, and the cycle allocates nothing on the adversarial poses.
#include <gtest/gtest.h>

#include <array>

#include "core/verify/adversarial_poses.hpp"
#include "core/verify/check_tools.hpp"
#include "core/verify/suite.hpp"
#include "tests/support/no_alloc.hpp"

namespace abstand::verify {
namespace checks_test {

class VerifyChecks : public ::testing::TestWithParam<CheckFamily> {};

TEST_P(VerifyChecks, Pass) {
  VerifyOptions options;
  options.poses = 6'000;
  options.quick = true;
  options.threads = 2;
  const std::vector<CheckResult> results = GetParam().run(options);
  ASSERT_FALSE(results.empty());
  for (const CheckResult& r : results) {
    EXPECT_TRUE(r.passed) << r.name << ": " << r.quantity << ", worst " << r.worst << ", limit " << r.limit
                          << ", " << r.breaches << " breaches";
    EXPECT_GT(r.poses, 0u) << r.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Families, VerifyChecks, ::testing::ValuesIn(checkFamilies()), [](const auto& test) {
  std::string name(test.param.name);
  for (char& c : name)
    if (c == ' ') c = '_';
  return name;
});

TEST(InterruptedChecks, DoNotPass) {
  VerifyOptions options;
  options.poses = 100;
  options.quick = true;
  options.interrupted = [] { return true; };
  for (const CheckFamily& family : checkFamilies()) {
    if (family.name == "same bits" || family.name == "third law") continue;  // the same bodies again
    for (const CheckResult& r : family.run(options)) EXPECT_FALSE(r.passed) << r.name;
  }
}

TEST(AdversarialPoses, CycleAllocatesNothing) {
  const std::vector<AdversarialBody> bodies = adversarialBodies(0);
  kernels::PairScratch scratch;
  query::PairResult result;
  long allocations = 0;
  int touching = 0;
  for (std::uint64_t i = 0; i < 2'000; ++i) {
    const AdversarialPose pose = adversarialPose(bodies, 3, i);
    const std::size_t field = i % kFields.size();
    const structure::HapticStructure &a = *bodies[pose.a].structures[field],
                                     &b = *bodies[pose.b].structures[field];
    const testing::NoAlloc guard;
    query::queryPair({a, pose.X_WA}, {b, pose.X_WB}, {.margin = 0.01}, scratch, result);
    allocations += guard.count();
    touching += result.contacts > 0;
  }
  EXPECT_EQ(allocations, 0);
  EXPECT_GT(touching, 500);
}

TEST(AdversarialPoses, AreReproducibleAndOfEveryFamily) {
  const std::vector<AdversarialBody> bodies = adversarialBodies(0);
  std::array<int, kPoseFamilies> count{};
  for (std::uint64_t i = 0; i < 2'000; ++i) {
    const AdversarialPose pose = adversarialPose(bodies, 3, i), again = adversarialPose(bodies, 3, i);
    EXPECT_TRUE(pose.X_WA.matrix() == again.X_WA.matrix() && pose.X_WB.matrix() == again.X_WB.matrix());
    EXPECT_TRUE(isPose(pose.X_WA, 1e-9) && isPose(pose.X_WB, 1e-9)) << i;
    ++count[static_cast<std::size_t>(pose.family)];
  }
  for (const int n : count) EXPECT_GT(n, 100);
}

}  // namespace checks_test
}  // namespace abstand::verify
