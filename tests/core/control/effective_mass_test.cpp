// The mass that is felt along a direction.
#include "core/control/effective_mass.hpp"

#include <gtest/gtest.h>

#include "core/math/random.hpp"
#include "tests/support/no_alloc.hpp"

namespace abstand::control {
namespace effective_mass_test {

TEST(EffectiveMass, PointMassesAndLeversMatchClosedForm) {
  EffectiveMass mass(2);
  // Two carts of 2 kg and 6 kg pushed by one force at both: 1 / (1/2 + 1/6).
  ASSERT_TRUE(mass.factorize(Eigen::Vector2d(2.0, 6.0).asDiagonal().toDenseMatrix()));
  const double both[] = {1.0, 1.0}, first[] = {1.0, 0.0}, none[] = {0.0, 0.0};
  EXPECT_NEAR(mass.mass(both), 1.5, 1e-12);
  EXPECT_NEAR(mass.mass(first), 2.0, 1e-12);
  EXPECT_EQ(mass.mass(none), kInfinity);
  // A rod of inertia 0.3 kg m^2 about its joint, felt at 0.5 m: I / l^2.
  EffectiveMass arm(1);
  ASSERT_TRUE(arm.factorize(Eigen::MatrixXd::Constant(1, 1, 0.3)));
  const double lever[] = {0.5};
  EXPECT_NEAR(arm.mass(lever), 1.2, 1e-12);
}

TEST(EffectiveMass, MatchesInverseQuadraticForm) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    Random random(4, seed);
    const int dof = 1 + static_cast<int>(random.below(47));
    Eigen::MatrixXd A(dof, dof);
    Eigen::VectorXd row(dof);
    for (int i = 0; i < dof; ++i) {
      row[i] = random.between(-1, 1);
      for (int k = 0; k < dof; ++k) A(i, k) = random.between(-1, 1);
    }
    const Eigen::MatrixXd M = A * A.transpose() + Eigen::MatrixXd::Identity(dof, dof);
    EffectiveMass mass(dof);
    const testing::NoAlloc guard;
    ASSERT_TRUE(mass.factorize(M));
    const double found = mass.mass({row.data(), static_cast<std::size_t>(dof)});
    EXPECT_EQ(guard.count(), 0);
    EXPECT_NEAR(found * row.dot(M.inverse() * row), 1.0, 1e-9);
  }
}

TEST(EffectiveMass, IsUnknownForInvalidMassMatrix) {
  EffectiveMass mass(2);
  const double row[] = {1.0, 0.0};
  EXPECT_FALSE(mass.factorize(Eigen::MatrixXd(0, 0)));
  EXPECT_FALSE(mass.factorize(Eigen::MatrixXd::Identity(3, 3)));
  EXPECT_FALSE(mass.factorize(-Eigen::MatrixXd::Identity(2, 2)));
  EXPECT_FALSE(mass.factorize(Eigen::MatrixXd::Constant(2, 2, kNaN)));
  EXPECT_TRUE(std::isnan(mass.mass(row)));
  EXPECT_TRUE(mass.factorize(Eigen::MatrixXd::Identity(2, 2)));
}

}  // namespace effective_mass_test
}  // namespace abstand::control
