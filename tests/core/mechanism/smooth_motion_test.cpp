// Motions with velocities and accelerations.
#include "core/mechanism/smooth_motion.hpp"

#include <gtest/gtest.h>

#include "tests/support/robots.hpp"

namespace abstand::mechanism {
namespace smooth_motion_test {

using testing::randomValues;

// Rounding of a few sums and products near 10.
constexpr double kExact = 1e-9;

struct Sample {
  std::vector<double> q, qd, qdd;
};
Sample sample(const SmoothMotion& motion, double t) {
  const auto n = static_cast<std::size_t>(motion.dof());
  Sample s{std::vector<double>(n), std::vector<double>(n), std::vector<double>(n)};
  motion.at(t, s.q, s.qd, s.qdd);
  return s;
}

MotionTable randomTable(std::uint64_t seed, int rows) {
  std::vector<double> t{0.5};
  for (const double step : randomValues(rows - 1, seed, 0, 0.4)) t.push_back(t.back() + 0.5 + step);
  return {t, randomValues(2 * rows, seed, 100, 2.0), 2};
}

TEST(SmoothMotion, InterpolatesRowsSmoothlyFromRestToRest) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    const MotionTable table = randomTable(seed, 2 + static_cast<int>(seed % 7));
    const SmoothMotion motion(table);
    for (std::size_t i = 0; i < table.rows(); ++i) {
      const double t = table.times()[i], e = 1e-9;
      const Sample s = sample(motion, t), before = sample(motion, t - e), after = sample(motion, t + e);
      for (std::size_t k = 0; k < 2; ++k) {
        EXPECT_NEAR(s.q[k], table.values()[2 * i + k], kExact);
        EXPECT_NEAR(before.qd[k], after.qd[k], 1e-6);
        const bool end = i == 0 || i + 1 == table.rows();
        if (end)
          EXPECT_NEAR(s.qd[k], 0.0, kExact);
        else
          EXPECT_NEAR(before.qdd[k], after.qdd[k], 1e-5);
      }
    }
    EXPECT_EQ(sample(motion, -1.0).q, sample(motion, 0.5).q);
    EXPECT_EQ(sample(motion, 99.0).qdd, std::vector<double>(2, 0.0));
  }
}

TEST(SmoothMotion, RatesMatchFiniteDifferences) {
  constexpr double kStep = 1e-5;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const SmoothMotion motion(randomTable(seed, 6));
    const double t = 0.5 + 0.3 * (motion.end() - motion.start());
    const Sample s = sample(motion, t), plus = sample(motion, t + kStep), minus = sample(motion, t - kStep);
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_NEAR((plus.q[k] - minus.q[k]) / (2 * kStep), s.qd[k], 1e-6);
      EXPECT_NEAR((plus.qd[k] - minus.qd[k]) / (2 * kStep), s.qdd[k], 1e-4);
    }
  }
}

TEST(SmoothMotion, ReproducesCubicFromRestToRest) {
  // q = 3 t^2 - 2 t^3 from 0 to 1, sampled anywhere.
  std::vector<double> t{0.0, 0.1, 0.35, 0.8, 1.0}, q;
  for (const double x : t) q.push_back(x * x * (3 - 2 * x));
  const SmoothMotion motion(MotionTable(t, q, 1));
  for (double x = 0.05; x < 1.0; x += 0.1) {
    const Sample s = sample(motion, x);
    EXPECT_NEAR(s.q[0], x * x * (3 - 2 * x), kExact);
    EXPECT_NEAR(s.qd[0], 6 * x * (1 - x), kExact);
    EXPECT_NEAR(s.qdd[0], 6 - 12 * x, kExact);
  }
}

}  // namespace smooth_motion_test
}  // namespace abstand::mechanism
