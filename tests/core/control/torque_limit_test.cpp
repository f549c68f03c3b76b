// Gain and limit of contact efforts.
#include "core/control/torque_limit.hpp"

#include <gtest/gtest.h>

#include "core/base/error.hpp"
#include "core/math/random.hpp"

namespace abstand::control {
namespace torque_limit_test {

constexpr double kExact = 1e-12;

TEST(TorqueLimit, AppliesGainAndLimitPerJoint) {
  const TorqueLimit law({.gain = 0.5, .limit = {10.0, 20.0, 5.0}, .cut = TorqueCut::kEach}, 3);
  const std::vector<double> efforts{30.0, -60.0, 4.0};
  std::vector<double> torque(3);
  EXPECT_EQ(law.update(efforts, torque), 0) << "15 of 10 and 30 of 20: the first of equals";
  EXPECT_EQ(torque, (std::vector<double>{10.0, -20.0, 2.0}));
}

TEST(TorqueLimit, JointLimitKeepsDirection) {
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    Random random(1, seed);
    std::vector<double> limits(7), efforts(7), torque(7);
    for (int i = 0; i < 7; ++i) {
      limits[i] = random.between(1.0, 50.0);
      efforts[i] = random.between(-100.0, 100.0);
    }
    const TorqueLimit law({.gain = 2.0, .limit = limits}, 7);
    const int joint = law.update(efforts, torque);
    const double factor = torque[0] / (2.0 * efforts[0]);
    double fullest = 0.0;
    for (int i = 0; i < 7; ++i) {
      ASSERT_NEAR(torque[i], 2.0 * factor * efforts[i], 1e-10);
      ASSERT_LE(std::abs(torque[i]), limits[i]);
      fullest = std::max(fullest, std::abs(torque[i]) / limits[i]);
    }
    if (joint < 0) {
      ASSERT_EQ(factor, 1.0);
    } else {
      ASSERT_NEAR(fullest, 1.0, kExact);
      ASSERT_NEAR(std::abs(torque[joint]), limits[joint], kExact * 50);
    }
  }
}

TEST(TorqueLimit, NonFiniteIsZeroedAndReported) {
  for (const TorqueCut cut : {TorqueCut::kEach, TorqueCut::kTogether}) {
    const TorqueLimit law({.limit = {10.0}, .cut = cut}, 3);
    std::vector<double> torque{kNaN, 5.0, -kInfinity};
    EXPECT_EQ(law.cut(torque), 0);
    EXPECT_EQ(torque, (std::vector<double>{0.0, 5.0, 0.0}));
  }
}

TEST(TorqueLimit, ZeroLimitAllowsNothing) {
  const TorqueLimit law({.limit = {0.0, 5.0}}, 2);
  std::vector<double> torque{0.0, 3.0};
  EXPECT_EQ(law.cut(torque), -1);
  EXPECT_EQ(torque, (std::vector<double>{0.0, 3.0}));
  torque = {1.0, 3.0};
  EXPECT_EQ(law.cut(torque), 0);
  EXPECT_EQ(torque, (std::vector<double>{0.0, 0.0}));
}

TEST(TorqueLimit, RejectsBadOptions) {
  EXPECT_THROW(TorqueLimit({.gain = -1.0}, 2), UsageError);
  try {
    TorqueLimit({.limit = {1.0, 2.0, 3.0}}, 2);
    FAIL();
  } catch (const UsageError& e) {
    EXPECT_STREQ(e.what(), "torque.limit: found 3 numbers, expected one, or one for each of 2 joints");
  }
}

}  // namespace torque_limit_test
}  // namespace abstand::control
