// A program at another pace: the same path, nowhere faster than permitted, changes no harder than told.
#include "app/tune/program_pace.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/math/transform.hpp"

namespace abstand::tune {
namespace program_pace_test {

// Relative: times are sums of some thousand numbers.
constexpr double kRounding = 1e-9;
// rad or m: joint values interpolated at rounded times.
constexpr double kOnPath = 1e-9;
// s: a change of pace begins somewhere within a step.
constexpr double kWithinStep = 1e-3;

/// One joint at `speed` for two seconds.
std::vector<ProgramMotion> straight(double speed) { return {{"arm", {{0.0, 2.0}, {0.0, 2.0 * speed}, 1}}}; }

/// Of each interval between rows of `slow`: its speeds and where it lies in the program.
template <class Visit>
void eachInterval(const mechanism::MotionTable& slow, const ProgramPace& pace, Visit visit) {
  const auto dof = static_cast<std::size_t>(slow.dof());
  for (std::size_t k = 0; k + 1 < slow.rows(); ++k) {
    const double duration = slow.times()[k + 1] - slow.times()[k];
    std::vector<double> speeds(dof);
    for (std::size_t j = 0; j < dof; ++j)
      speeds[j] = (slow.values()[(k + 1) * dof + j] - slow.values()[k * dof + j]) / duration;
    visit(pace.programAt(slow.times()[k] + 0.5 * duration), duration, speeds);
  }
}

TEST(ProgramPace, DeceleratesEvenlyBeforeSlowerSegment) {
  // From 1 to 0.5 of 1 rad/s with 2 rad/s^2: 0.25 s, over (1 - 0.25) / (2 * 2) s of the program.
  const auto motions = straight(1.0);
  const ProgramPace pace = permittedProgram({{0.0, 1.0, 1.0}, {1.0, 2.0, 0.5}}, motions, 2.0);
  const double ramp = 0.75 / 4.0;
  EXPECT_NEAR(pace.cycleTime(), (1.0 - ramp) + 0.25 + 1.0 / 0.5, kWithinStep);
  EXPECT_NEAR(pace.clockAt(1.0), (1.0 - ramp) + 0.25, kWithinStep);
  EXPECT_NEAR(pace.programAt(pace.clockAt(1.5)), 1.5, kRounding);
  // The other way round it takes as long.
  EXPECT_NEAR(permittedProgram({{0.0, 1.0, 0.5}, {1.0, 2.0, 1.0}}, motions, 2.0).cycleTime(),
              pace.cycleTime(), kWithinStep);
  // A robot that stands may change its pace at once: within a step.
  EXPECT_NEAR(permittedProgram({{0.0, 1.0, 1.0}, {1.0, 2.0, 0.5}}, straight(0.0), 2.0).cycleTime(), 3.0,
              kPaceStep);
}

TEST(ProgramPace, UniformPaceScalesTime) {
  const ProgramPace pace = ProgramPace::uniform(1.0, 3.0, 0.25);
  EXPECT_DOUBLE_EQ(pace.cycleTime(), 8.0);
  EXPECT_DOUBLE_EQ(pace.clockAt(2.0), 5.0);
  EXPECT_DOUBLE_EQ(pace.clockAt(0.5), 0.5) << "before it begins, program and clock are the same";
  EXPECT_DOUBLE_EQ(pace.programAt(100.0), 3.0) << "the end stands";
  const mechanism::MotionTable slow = retimed({{1.0, 2.0, 3.0}, {0.0, 5.0, 7.0}, 1}, pace);
  ASSERT_EQ(slow.rows(), 3u);
  EXPECT_DOUBLE_EQ(slow.times()[1], 5.0);
  EXPECT_DOUBLE_EQ(slow.times()[2], 9.0);
}

TEST(ProgramPace, IsFullSpeedWithoutLimits) {
  const auto motions = straight(1.0);
  const ProgramPace pace = permittedProgram({{0.0, 2.0, 1.0}}, motions, 2.0);
  EXPECT_NEAR(pace.cycleTime(), 2.0, kRounding * 4.0);
  const mechanism::MotionTable same = retimed(motions[0].motion, pace);
  ASSERT_EQ(same.rows(), 2u) << "no rows where nothing changes";
}

class RandomPrograms : public ::testing::TestWithParam<unsigned> {
 protected:
  /// Two mechanisms with rows of their own, and stretches of random scales.
  RandomPrograms() : random_(GetParam()) {
    for (const int dof : {1, 3}) {
      std::vector<double> t{uniform(0.0, 0.3)}, q(static_cast<std::size_t>(dof), 0.0);
      while (t.back() < 5.0) {
        t.push_back(t.back() + uniform(0.003, 0.4));
        for (int j = 0; j < dof; ++j)
          q.push_back(q[q.size() - static_cast<std::size_t>(dof)] + uniform(-0.3, 0.3));
      }
      motions_.push_back({"m" + std::to_string(dof), {t, q, dof}});
    }
    for (double t = 0.1; t < 5.5; t += 0.5) permitted_.push_back({t, t + 0.5, uniform(0.02, 1.0)});
  }
  double uniform(double from, double to) { return std::uniform_real_distribution<>(from, to)(random_); }
  double permittedAt(double p) const {
    double scale = 1.0;
    for (const PermittedPace& s : permitted_)
      if (p > s.t0 && p < s.t1) scale = s.scale;
    return scale;
  }

  static constexpr double kDeceleration = 3.0;
  std::mt19937 random_;
  std::vector<ProgramMotion> motions_;
  std::vector<PermittedPace> permitted_;
};

TEST_P(RandomPrograms, KeepPath) {
  const ProgramPace pace = permittedProgram(permitted_, motions_, kDeceleration);
  for (const ProgramMotion& m : motions_) {
    const mechanism::MotionTable slow = retimed(m.motion, pace);
    const auto dof = static_cast<std::size_t>(m.motion.dof());
    EXPECT_EQ(std::vector<double>(slow.values().begin(), slow.values().begin() + m.motion.dof()),
              std::vector<double>(dof, 0.0));
    std::vector<double> a(dof), b(dof);
    for (double t = -0.1; t < slow.end() + 0.1; t += 0.0017) {
      slow.at(t, a);
      m.motion.at(pace.programAt(t), b);
      for (std::size_t j = 0; j < dof; ++j) ASSERT_NEAR(a[j], b[j], kOnPath) << t;
    }
    // Every row is still one, to the last bit.
    std::size_t at = 0;
    for (std::size_t row = 0; row < m.motion.rows(); ++row) {
      const auto same = [&](std::size_t k) {
        return std::equal(m.motion.values().begin() + static_cast<long>(row * dof),
                          m.motion.values().begin() + static_cast<long>((row + 1) * dof),
                          slow.values().begin() + static_cast<long>(k * dof));
      };
      while (at < slow.rows() && !same(at)) ++at;
      ASSERT_LT(at, slow.rows()) << row;
    }
  }
}

TEST_P(RandomPrograms, NeverExceedPermittedSpeed) {
  const ProgramPace pace = permittedProgram(permitted_, motions_, kDeceleration);
  for (const ProgramMotion& m : motions_) {
    const auto dof = static_cast<std::size_t>(m.motion.dof());
    std::vector<double> q0(dof), q1(dof);
    // Through its file, as a scene reads it.
    const mechanism::MotionTable slow =
        mechanism::parseMotion(mechanism::formatMotion(retimed(m.motion, pace)), "slow.csv", m.motion.dof());
    eachInterval(slow, pace, [&](double p, double, const std::vector<double>& speeds) {
      const auto row = static_cast<std::size_t>(
          std::upper_bound(m.motion.times().begin(), m.motion.times().end(), p) - m.motion.times().begin());
      for (std::size_t j = 0; j < dof; ++j) {
        const double recorded = (m.motion.values()[row * dof + j] - m.motion.values()[(row - 1) * dof + j]) /
                                (m.motion.times()[row] - m.motion.times()[row - 1]);
        // rad/s: the difference of joint values that were rounded, per step.
        EXPECT_LE(std::abs(speeds[j]), permittedAt(p) * std::abs(recorded) * (1.0 + kRounding) + 1e-11) << p;
      }
    });
  }
}

TEST_P(RandomPrograms, NeverExceedDeceleration) {
  const ProgramPace pace = permittedProgram(permitted_, motions_, kDeceleration);
  std::size_t changes = 0;
  for (const ProgramMotion& m : motions_) {
    const auto dof = static_cast<std::size_t>(m.motion.dof());
    double last_p = -1.0, last_duration = 0.0;
    std::vector<double> last(dof, 0.0);
    eachInterval(
        retimed(m.motion, pace), pace, [&](double p, double duration, const std::vector<double>& speeds) {
          const auto rowOf = [&](double x) {
            return std::upper_bound(m.motion.times().begin(), m.motion.times().end(), x);
          };
          // Between two rows of the motion its recorded speed is one: what changes is the pace.
          if (last_p >= 0.0 && rowOf(p) == rowOf(last_p)) {
            const double between = 0.5 * (duration + last_duration);
            for (std::size_t j = 0; j < dof; ++j) {
              EXPECT_LE(std::abs(speeds[j] - last[j]), kDeceleration * between * (1.0 + 1e-6) + 1e-9) << p;
              changes += std::abs(speeds[j] - last[j]) > 0.5 * kDeceleration * between;
            }
          }
          last_p = p, last_duration = duration, last = speeds;
        });
  }
  EXPECT_GT(changes, 0u) << "somewhere the limit is used";
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomPrograms, ::testing::Range(1u, 21u));

}  // namespace program_pace_test
}  // namespace abstand::tune
