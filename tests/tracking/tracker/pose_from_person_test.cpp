// Poses of cameras from the person whom they see.
#include "tracking/tracker/pose_from_person.hpp"

#include <gtest/gtest.h>

#include <random>

#include "core/base/error.hpp"
#include "tests/tracking/tracker/posed_person.hpp"
#include "tests/tracking/tracker/simulated_clip.hpp"
#include "tracking/tracker/clip_tracker.hpp"
#include "tracking/tracker/turned_round.hpp"

namespace abstand::tracking {
namespace pose_from_person_test {

using humanmodel::SkeletonFrame;

constexpr double kExact = 1e-6;    // m, of numbers without noise
constexpr double kFrames = 0.002;  // s, of clocks, from images a thirtieth of a second apart
// Of a camera placed by what two trackers see from different sides.
constexpr double kPlaced = 0.08;   // m
constexpr double kTurned = 0.035;  // rad

/// Walks about and moves the hands.
std::vector<SkeletonFrame> walking() {
  return testing::posedFrames(std::vector<testing::Posture>{
      {.t = 0.0},
      {.t = 1.0, .hips = {0.3, 0.3, 0.90}, .reach = 0.35, .aside = 0.35, .low = 1.2, .foot = 0.3},
      {.t = 2.0, .hips = {0.5, 0.0, 0.92}, .reach = 0.60, .low = 0.9, .foot = 0.5},
      {.t = 3.2, .hips = {0.2, -0.4, 0.88}, .reach = 0.55, .aside = 0.3, .low = 1.4, .foot = 0.2},
      {.t = 4.2, .hips = {0.0, 0.0, 0.92}, .low = 0.95},
      {.t = 5.0, .hips = {-0.2, 0.3, 0.92}, .reach = 0.1, .low = 0.9, .foot = -0.2}});
}

Transform somewhere() {
  Transform X = Transform::Identity();
  X.linear() = (Eigen::AngleAxisd(2.0, Vector3d::UnitZ()) * Eigen::AngleAxisd(0.3, Vector3d::UnitY()))
                   .toRotationMatrix();
  X.translation() = Vector3d(1.0, -2.0, 0.4);
  return X;
}

std::vector<SkeletonFrame> seenFrom(const Transform& X_WC, std::vector<SkeletonFrame> frames, double late) {
  for (SkeletonFrame& frame : frames) {
    frame.t += late;
    for (Vector3d& p : frame.p) p = X_WC.inverse() * p;
  }
  return frames;
}

TEST(PoseFromPerson, IsExactWithoutNoise) {
  const auto world = walking();
  const PersonPoseFit fit = fitPoseToPerson(world, seenFrom(somewhere(), world, 1.5), Transform::Identity());
  EXPECT_LT((fit.X_WC.matrix() - somewhere().matrix()).norm(), kExact);
  EXPECT_NEAR(fit.clock, -1.5, kFrames);
  EXPECT_TRUE(fit.clock_known);
  EXPECT_FALSE(fit.exchanged);
  EXPECT_EQ(fit.used, fit.joints);
  EXPECT_GT(fit.moved, 0.5);
}

TEST(PoseFromPerson, ResultIsInCameraFrame) {
  const auto world = walking();
  const Transform X_FC = somewhere() * somewhere();
  const PersonPoseFit fit = fitPoseToPerson(world, seenFrom(somewhere(), world, 0.0), X_FC);
  EXPECT_LT((fit.X_WC.matrix() - (somewhere() * X_FC).matrix()).norm(), kExact);
}

TEST(PoseFromPerson, DetectsReversedFacing) {
  const auto world = walking();
  auto own = seenFrom(somewhere(), world, 0.0);
  for (SkeletonFrame& frame : own) frame = flippedFacing(frame);
  const PersonPoseFit fit = fitPoseToPerson(world, own, Transform::Identity());
  EXPECT_TRUE(fit.exchanged);
  // Feet are turned about the camera's z here, which is not that of the world: some toes are outliers.
  EXPECT_LT((fit.X_WC.matrix() - somewhere().matrix()).norm(), kTurned);
}

TEST(PoseFromPerson, RejectsDifferentPeopleAndNoCommonTime) {
  const auto world = walking();
  auto other = testing::posedFrames(
      std::vector<testing::Posture>{{.t = 0.0, .reach = 0.6, .low = 1.5},
                                    {.t = 1.0, .hips = {0.0, 0.0, 0.5}},
                                    {.t = 3.0, .hips = {0.0, 1.0, 0.9}, .aside = 0.7, .low = 1.4},
                                    {.t = 5.0, .hips = {2.0, 0.0, 0.9}}});
  EXPECT_THROW(fitPoseToPerson(world, other, Transform::Identity()), UsageError);
  EXPECT_THROW(fitPoseToPerson(world, seenFrom(somewhere(), world, 60.0), Transform::Identity()), UsageError);
  EXPECT_THROW(fitPoseToPerson(world, {}, Transform::Identity()), UsageError);
}

/// The message about frames whose joints are `rms` (m) beside those of `world`; empty: accepted.
std::string refusalAt(double rms, const std::vector<SkeletonFrame>& world) {
  std::vector<SkeletonFrame> own = world;
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal(0.0, rms / std::sqrt(3.0));
  for (SkeletonFrame& frame : own)
    for (Vector3d& p : frame.p) p += Vector3d(normal(random), normal(random), normal(random));
  try {
    fitPoseToPerson(world, own, Transform::Identity());
    return {};
  } catch (const UsageError& error) {
    return error.what();
  }
}

// Two motions of an audit had 131 mm, and gave a camera 2.1 m off.
TEST(PoseFromPerson, RefusesTwoMotionsThatAreAlike) {
  EXPECT_EQ(refusalAt(0.06, walking()), "");
  EXPECT_NE(refusalAt(0.12, walking()).find("expected one person"), std::string::npos);
  const auto still = testing::posedFrames(std::vector<testing::Posture>{{.t = 0.0}, {.t = 5.0}});
  EXPECT_EQ(refusalAt(0.05, still), "");
  EXPECT_NE(refusalAt(0.08, still).find("clock offset"), std::string::npos);
}

TEST(PoseFromPerson, PlacesSecondCameraFromTracks) {
  std::vector<ClipTrack> tracks;
  std::vector<Transform> truth;
  for (const Vector3d& eye : {Vector3d(3.2, 0.0, 1.6), Vector3d(1.6, -2.8, 1.4)}) {
    auto clip = testing::simulate({.recording = {}, .eye = eye, .look = {0.2, 0.0, 0.9}, .room = true},
                                  walking(), {});
    truth.push_back(clip.stream->camera().X_WC);
    tracks.push_back(trackClip(*clip.stream, {}));
    ASSERT_FALSE(tracks.back().people.empty());
  }
  // The second camera's people, in its own frame.
  const auto own = seenFrom(truth[1], tracks[1].people[0].frames, 0.0);
  const PersonPoseFit fit = fitPoseToPerson(tracks[0].people[0].frames, own, Transform::Identity());
  const double off = (fit.X_WC.translation() - truth[1].translation()).norm();
  const double turned = Eigen::AngleAxisd(fit.X_WC.linear().transpose() * truth[1].linear()).angle();
  // Where the person is, which is what counts when the images of both are fitted.
  double squares = 0.0, axes = 0.0;
  for (const SkeletonFrame& frame : own)
    for (std::size_t j = 0; j < humanmodel::kJointCount; ++j) {
      if (frame.state[j] != humanmodel::JointState::kTracked) continue;
      squares += (fit.X_WC * frame.p[j] - truth[1] * frame.p[j]).squaredNorm();
      axes += 3.0;
    }
  const double at_person = std::sqrt(squares / axes);
  std::printf(
      "placed %.0f mm off, turned by %.2f degrees, an axis of a joint off by %.0f mm; %.0f mm RMS, "
      "spread %.0f mm, clock %+.3f s\n",
      1e3 * off, turned / unit::deg(1.0), 1e3 * at_person, 1e3 * fit.rms, 1e3 * fit.spread, fit.clock);
  EXPECT_LT(at_person, fit.spread);
  EXPECT_LT(off, 3.0 * fit.spread);
  EXPECT_LT(off, kPlaced);
  EXPECT_LT(turned, kTurned);
  EXPECT_NEAR(fit.clock, 0.0, 0.02);
}

}  // namespace pose_from_person_test
}  // namespace abstand::tracking
