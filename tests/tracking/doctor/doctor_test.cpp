// The tracker doctor against recordings whose illness is known.
#include "tracking/doctor/doctor.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "humanmodel/part_uncertainty.hpp"

#include <cmath>
#include <random>

namespace abstand::tracking {
namespace doctor_test {

constexpr double kRate = 100.0;

/// A person who walks along x at 1 m/s, with white noise of `noise` (m) in every coordinate.
Recording walker(std::size_t frames, double noise = 0.0) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal(0.0, 1.0);
  Recording r;
  for (std::size_t i = 0; i < frames; ++i) {
    humanmodel::SkeletonFrame f;
    f.t = static_cast<double>(i) / kRate;
    for (std::size_t j = 0; j < humanmodel::kJointCount; ++j) {
      const bool is_right = humanmodel::jointName(static_cast<humanmodel::Joint>(j)).ends_with("right");
      Vector3d p(f.t, is_right ? -0.2 : 0.2, 0.07 * static_cast<double>(j));
      if (noise > 0.0) p += noise * Vector3d(normal(random), normal(random), normal(random));
      f.set(static_cast<humanmodel::Joint>(j), p);
    }
    r.frames.push_back(f);
  }
  return r;
}

const JointHealth& healthOf(const DoctorReport& r, humanmodel::Joint j) {
  for (const auto& h : r.joints)
    if (h.joint == humanmodel::jointName(j)) return h;
  throw std::logic_error("no such joint");
}

TEST(Doctor, FindsNothingInSoundRecording) {
  const DoctorReport r = examine(walker(100));
  EXPECT_NEAR(r.step, 0.01, 1e-12);
  EXPECT_EQ(r.uneven_steps, 0u);
  EXPECT_EQ(r.bones.size(), 14u);
  for (const auto& b : r.bones) EXPECT_LT(b.spread + std::abs(b.drift), 1e-12) << b.part;
  EXPECT_TRUE(r.swaps.empty());
  EXPECT_TRUE(r.jumps.empty());
  EXPECT_LT(healthOf(r, humanmodel::Joint::kNeck).jitter, 1e-12);
  EXPECT_NEAR(healthOf(r, humanmodel::Joint::kNeck).speed, 1.0, 1e-9);
  EXPECT_EQ(r.fill.filled + r.fill.left, 0u);
}

// 3 x 2000 samples: the median's estimate of a standard deviation is good to 3 % at twice its own deviation.
TEST(Doctor, MeasuresWhiteNoise) {
  for (const double noise : {0.0005, 0.004})
    EXPECT_NEAR(jitterOf(walker(2000, noise).frames, humanmodel::Joint::kNeck), noise, 0.05 * noise);
}

TEST(Doctor, FindsGapsJumpsSwapsAndDrift) {
  Recording r = walker(100);
  for (std::size_t i = 20; i < 30; ++i)
    r.frames[i].set(humanmodel::Joint::kWristLeft, Vector3d::Constant(kNaN),
                    humanmodel::JointState::kMissing);
  r.frames[50].p[static_cast<std::size_t>(humanmodel::Joint::kHead)].z() += 0.5;
  for (std::size_t i = 70; i < 100; ++i)
    for (const auto& [a, b] : {std::pair{humanmodel::Joint::kHipLeft, humanmodel::Joint::kHipRight},
                               {humanmodel::Joint::kShoulderLeft, humanmodel::Joint::kShoulderRight}})
      std::swap(r.frames[i].p[static_cast<std::size_t>(a)], r.frames[i].p[static_cast<std::size_t>(b)]);
  for (std::size_t i = 0; i < 100; ++i)
    r.frames[i].p[static_cast<std::size_t>(humanmodel::Joint::kToeLeft)].z() +=
        0.001 * static_cast<double>(i);
  const DoctorReport report = examine(r);
  EXPECT_EQ(healthOf(report, humanmodel::Joint::kWristLeft).missing, 10u);
  EXPECT_NEAR(healthOf(report, humanmodel::Joint::kWristLeft).longest_gap, 0.11, 1e-9)
      << "from place to place";
  EXPECT_THAT(report.swaps, ::testing::ElementsAre(::testing::DoubleNear(0.7, 1e-9)));
  const auto of_head = std::count_if(report.jumps.begin(), report.jumps.end(),
                                     [](const Jump& j) { return j.joint == "head"; });
  EXPECT_EQ(of_head, 2) << "there and back";
  EXPECT_NEAR(report.jumps.front().speed, 50.0, 0.1);
  const auto foot = std::find_if(report.bones.begin(), report.bones.end(),
                                 [](const BoneHealth& b) { return b.part == "foot_left"; });
  EXPECT_NEAR(foot->drift, 0.09, 1e-3) << "0.001 m a frame, middle of the last ten to that of the first";
  EXPECT_EQ(report.fill.filled, 10u);
}

TEST(Filters, ButterworthHasStatedDelayAndCutoff) {
  Butterworth ramp(6.0, kRate);
  Vector3d y;
  for (int i = 0; i <= 400; ++i) y = ramp.step(Vector3d(i / kRate, 2.0, 0.0));
  EXPECT_NEAR(4.0 - y.x(), ramp.delay(), 1e-9);
  EXPECT_NEAR(y.y(), 2.0, 1e-12);
  EXPECT_NEAR(ramp.delay(), std::sqrt(2.0) / (2.0 * kPi * 6.0), 5e-4) << "the analog filter's, s";
  Butterworth sine(6.0, kRate);
  double largest = 0.0;
  for (int i = 0; i < 5000; ++i) {
    const double v = sine.step(Vector3d(std::sin(2.0 * kPi * 6.0 * i / kRate), 0, 0)).x();
    if (i > 1000) largest = std::max(largest, std::abs(v));
  }
  EXPECT_NEAR(largest, std::sqrt(0.5), 2e-3) << "sampled near its crests";
}

TEST(Filters, OneEuroHasStatedDelayAtEverySpeed) {
  for (const double speed : {0.1, 1.0, 3.0}) {
    OneEuro filter({}, kRate);
    Vector3d y;
    for (int i = 0; i <= 2000; ++i) y = filter.step(Vector3d(speed * i / kRate, 0, 0));
    EXPECT_NEAR((speed * 20.0 - y.x()) / speed, filter.delay(speed), 1e-6) << speed;
  }
}

TEST(Filters, AreReportedBeforeAndAfter) {
  const DoctorReport r = examine(walker(1000, 0.003));
  ASSERT_EQ(r.filters.size(), 3u);
  for (const auto& f : r.filters) {
    EXPECT_NEAR(f.jitter_before, 0.003, 0.0003) << f.name;
    EXPECT_LT(f.jitter_after, 0.5 * f.jitter_before) << f.name;
  }
  EXPECT_EQ(r.filters[2].delay, 0.0);
  EXPECT_LT(r.filters[2].moved, r.filters[1].moved) << "no lag of the walk";
  EXPECT_GT(r.filters[0].delay_at_rest, r.filters[0].delay);
}

TEST(Filters, RestartAfterGap) {
  Recording r = walker(20);
  r.frames[10].set(humanmodel::Joint::kNeck, Vector3d::Constant(kNaN), humanmodel::JointState::kMissing);
  const Vector3d behind = r.frames[11][humanmodel::Joint::kNeck];
  smooth(r.frames, kRate, Smoothing::kButterworth);
  EXPECT_FALSE(r.frames[10].has(humanmodel::Joint::kNeck));
  EXPECT_LT((r.frames[11][humanmodel::Joint::kNeck] - behind).norm(), 1e-12);
}

// A cubic in time comes back exactly from a Hermite curve whose end velocities are exact; ours are one-sided
// differences, so a straight walk is exact and the bone's length rules elsewhere.
TEST(GapFill, KeepsTrajectoryAndLimbLengths) {
  Recording r = walker(50);
  // The forearm turns about the elbow at 2 rad/s.
  constexpr double kLength = 0.25;
  for (auto& f : r.frames)
    f.set(humanmodel::Joint::kWristLeft,
          f[humanmodel::Joint::kElbowLeft] + kLength * Vector3d(std::cos(2 * f.t), std::sin(2 * f.t), 0));
  const Recording whole = r;
  for (std::size_t i = 20; i < 30; ++i) {
    r.frames[i].set(humanmodel::Joint::kWristLeft, Vector3d::Constant(kNaN),
                    humanmodel::JointState::kMissing);
    r.frames[i].set(humanmodel::Joint::kNeck, Vector3d::Constant(kNaN), humanmodel::JointState::kMissing);
  }
  for (std::size_t i = 0; i < 5; ++i)
    r.frames[i].set(humanmodel::Joint::kHead, Vector3d::Constant(kNaN), humanmodel::JointState::kMissing);
  const GapFill fill = fillGaps(r.frames, 0.2);
  EXPECT_EQ(fill.filled, 20u);
  EXPECT_EQ(fill.left, 5u) << "nothing is known before the start";
  for (std::size_t i = 20; i < 30; ++i) {
    EXPECT_LT((r.frames[i][humanmodel::Joint::kNeck] - whole.frames[i][humanmodel::Joint::kNeck]).norm(),
              1e-12);
    EXPECT_NEAR(
        (r.frames[i][humanmodel::Joint::kWristLeft] - r.frames[i][humanmodel::Joint::kElbowLeft]).norm(),
        kLength, 1e-12);
    EXPECT_LT(
        (r.frames[i][humanmodel::Joint::kWristLeft] - whole.frames[i][humanmodel::Joint::kWristLeft]).norm(),
        2e-4);
    EXPECT_EQ(r.frames[i].state[static_cast<std::size_t>(humanmodel::Joint::kWristLeft)],
              humanmodel::JointState::kInferred);
    // Unseen since frame 19 and until frame 30.
    const double unseen =
        std::min(whole.frames[i].t - whole.frames[19].t, whole.frames[30].t - whole.frames[i].t);
    EXPECT_NEAR(
        humanmodel::kSpreadQuantile * r.frames[i].spread[static_cast<std::size_t>(humanmodel::Joint::kNeck)],
        humanmodel::kPersonSpeed * unseen, 1e-12);
  }
  EXPECT_EQ(fillGaps(r.frames, 0.05).filled, 0u);
}

}  // namespace doctor_test
}  // namespace abstand::tracking
