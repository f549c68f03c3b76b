// Thesis experiment 5.1: a chain of three links follows q_i = arcsin(0.5 sin(alpha)), eq. 5.1, in its plane.
#include <gtest/gtest.h>

#include <complex>

#include "core/robot_file/mech_file.hpp"
#include "tests/support/paths.hpp"

namespace abstand {
namespace chain_test {

constexpr double kLength = 1.1;  // m, listing 5.1
constexpr double kCenter = 0.5;  // m, centre of a link in its frame, listing 5.1
constexpr double kPeriod = 4.0;  // s, one turn of alpha
constexpr double kDt = 0.001;    // s, the thesis's rate
constexpr int kSteps = 4000;
constexpr double kRounding = 1e-14;  // of three products of numbers near 1, relative to a reach of 3.3 m

TEST(ExperimentChain, MatchesClosedFormInPlane) {
  const mechanism::Mechanism chain =
      robot_file::loadMechanism(testing::projectFile("data/scenes/chain.mech"));
  ASSERT_EQ(chain.dof, 3);
  mechanism::MechanismState state;
  std::vector<double> q(3);
  double worst = 0.0;
  for (int step = 0; step <= kSteps; ++step) {
    const double alpha = 2.0 * kPi * step * kDt / kPeriod;
    const double q_i = std::asin(0.5 * std::sin(alpha));
    q.assign(3, q_i);
    mechanism::forward(chain, q, state);

    // In the plane a pose is a complex number e^{i phi}: sin q_i = 0.5 sin(alpha), cos q_i = sqrt(1 - sin^2
    // q_i).
    const double s = 0.5 * std::sin(alpha);
    const std::complex<double> turn(std::sqrt(1.0 - s * s), s);
    std::complex<double> direction = 1.0, origin = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      direction *= turn;
      const Transform& X_BF = state.X_BF[i];
      const Vector3d expected(origin.real(), origin.imag(), 0.0);
      const std::complex<double> center = origin + kCenter * direction;
      const Vector3d expected_center(center.real(), center.imag(), 0.0);
      worst = std::max({worst, (X_BF.translation() - expected).norm(),
                        (X_BF * chain.frames[i].X_FC.translation() - expected_center).norm(),
                        std::abs(X_BF.linear()(0, 0) - direction.real()),
                        std::abs(X_BF.linear()(1, 0) - direction.imag())});
      EXPECT_TRUE(isPose(X_BF));
      origin += kLength * direction;
    }
  }
  EXPECT_LT(worst, kRounding * 3.0 * kLength);
}

TEST(ExperimentChain, SwingsThirtyDegreesPerJointAndReturns) {
  const mechanism::Mechanism chain =
      robot_file::loadMechanism(testing::projectFile("data/scenes/chain.mech"));
  mechanism::MechanismState state;
  // At alpha = 90 degrees every joint stands at 30: the links point to 30, 60 and 90 degrees.
  mechanism::forward(chain, std::vector(3, std::asin(0.5)), state);
  const double tolerance = 1e-15 * 100;
  EXPECT_NEAR(state.X_BF[2].translation().x(), kLength * (std::sqrt(3.0) / 2 + 0.5), tolerance);
  EXPECT_NEAR(state.X_BF[2].translation().y(), kLength * (0.5 + std::sqrt(3.0) / 2), tolerance);
  EXPECT_NEAR(state.X_BF[2].linear()(1, 0), 1.0, tolerance);
}

}  // namespace chain_test
}  // namespace abstand
