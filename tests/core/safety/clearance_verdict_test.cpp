// One rule for window, gate and reports.
#include "core/safety/clearance_verdict.hpp"

#include <gtest/gtest.h>

#include "core/math/transform.hpp"

namespace abstand::safety {
namespace clearance_verdict_test {

using enum ClearanceVerdict;

TEST(ClearanceVerdict, IsKeptOnlyIfCertified) {
  EXPECT_EQ(verdict({0.5, 0.0, 0.0}, 0.5), kKept) << "at the limit";
  EXPECT_EQ(verdict({0.5, 0.1, 0.0}, 0.4), kKept);
  EXPECT_EQ(verdict({0.5, 0.11, 0.0}, 0.4), kNotProven);
  EXPECT_EQ(verdict({0.39, 0.0, 0.0}, 0.4), kBroken);
  EXPECT_EQ(verdict({-0.01, 0.0, 0.0}, 0.0), kBroken) << "penetration";
}

TEST(ClearanceVerdict, IsWidenedByPoseUncertainty) {
  EXPECT_EQ(verdict({0.5, 0.0, 0.1}, 0.4), kKept);
  EXPECT_EQ(verdict({0.5, 0.01, 0.1}, 0.4), kNotProven);
  EXPECT_EQ(verdict({0.5, 0.0, 0.11}, 0.4), kBroken);
}

TEST(ClearanceVerdict, UnknownIsNeverKept) {
  EXPECT_EQ(verdict({kNaN, 0.0, 0.0}, 0.0), kBroken);
  EXPECT_EQ(verdict({1.0, 0.0, kInfinity}, 0.0), kBroken);
  EXPECT_EQ(verdict({1.0, kInfinity, 0.0}, 0.0), kNotProven);
  EXPECT_EQ(verdict({1.0, kNaN, 0.0}, 0.0), kNotProven);
  EXPECT_EQ(verdict({kInfinity, 0.0, kInfinity}, 0.0), kBroken);
}

TEST(CertifiedClearance, SubtractsBoundAndUncertainty) {
  EXPECT_DOUBLE_EQ(certifiedClearance({0.5, 0.1, 0.15}), 0.25);
  EXPECT_EQ(certifiedClearance({kNaN, 0.0, 0.0}), -kInfinity);
  EXPECT_EQ(certifiedClearance({0.5, 0.0, kInfinity}), -kInfinity);
  EXPECT_EQ(certifiedClearance({kInfinity, 0.0, kInfinity}), -kInfinity);
}

}  // namespace clearance_verdict_test
}  // namespace abstand::safety
