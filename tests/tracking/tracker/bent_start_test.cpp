// Poses of people who squat or bend, and fits that are alike.
#include "tracking/tracker/bent_start.hpp"

#include <gtest/gtest.h>

#include <span>

#include "tests/support/no_alloc.hpp"
#include "tracking/tracker/alike_fits.hpp"
#include "tracking/tracker/turned_round.hpp"

namespace abstand::tracking {
namespace bent_start_test {

using humanmodel::Joint;

constexpr double kTop = 1.0;  // m, of the back

BodyRig rigOfAdult() { return makeRig(humanmodel::makeHuman({})); }

SeenPoints alongX() {
  SeenPoints points;
  for (double x = -0.4; x <= 0.41; x += 0.05) {
    points.x[points.count] = static_cast<float>(x);
    points.y[points.count] = static_cast<float>(0.02 * std::sin(40.0 * x));
    points.z[points.count++] = 0.9f;
  }
  return points;
}

TEST(BentStarts, StandOnBothFeetWithTheHeadAtEitherEnd) {
  const BodyRig rig = rigOfAdult();
  const SeenPoints points = alongX();
  std::array<RigPose, kBentStarts> starts;
  bentStarts(rig, points, Vector3d::Zero(), kTop, 0.0, starts);
  int ahead = 0;
  for (const RigPose& start : std::span(starts).first(kBentStarts - 1)) {
    RigPlacement X_WS;
    place(rig, start, X_WS);
    const auto at = [&](Joint joint) { return jointPosition(rig, X_WS, joint); };
    for (const Joint ankle : {Joint::kAnkleLeft, Joint::kAnkleRight}) {
      EXPECT_GT(at(ankle).z(), 0.0);
      EXPECT_LT(at(ankle).z(), 0.2) << "on the floor";
    }
    for (const Joint wrist : {Joint::kWristLeft, Joint::kWristRight})
      EXPECT_LT(at(wrist).z(), at(Joint::kPelvis).z()) << "the arms hang";
    const Vector3d back = at(Joint::kNeck) - at(Joint::kPelvis);
    EXPECT_GT(std::abs(back.x()), std::abs(back.z())) << "bent";
    EXPECT_LT(std::abs(back.y()), 0.05);
    EXPECT_LT(at(Joint::kHeadTop).z(), kTop + 0.35);
    EXPECT_LT(at(Joint::kPelvis).x() * back.x(), 0.0) << "hips and head at opposite ends";
    ahead += back.x() > 0.0 ? 1 : -1;
  }
  EXPECT_EQ(ahead, 0);
}

// The points of somebody behind a bench may be those of both arms.
TEST(BentStarts, LastOneFacesAsExpected) {
  constexpr double kFacing = 0.5 * kPi;  // rad
  const BodyRig rig = rigOfAdult();
  std::array<RigPose, kBentStarts> starts;
  bentStarts(rig, alongX(), Vector3d::Zero(), kTop, kFacing, starts);
  EXPECT_NEAR(yawOf(starts.back()), kFacing, 1e-12);
  for (const RigPose& start : std::span(starts).first(kBentStarts - 1))
    EXPECT_GT(std::abs(std::cos(yawOf(start))), 0.9);
}

TEST(BentStarts, AllocateNothing) {
  const BodyRig rig = rigOfAdult();
  const SeenPoints points = alongX();
  std::array<RigPose, kBentStarts> starts;
  testing::NoAlloc guard;
  bentStarts(rig, points, Vector3d::Zero(), kTop, 0.0, starts);
}

TEST(AlikeFits, AreApartAsFarAsTheFarthestThatCostsHardlyMore) {
  const BodyRig rig = rigOfAdult();
  AlikeFits fits(rig);
  EXPECT_EQ(fits.apart()[0], 0.0);
  const auto add = [&](double x, double cost) {
    RigPose pose;
    pose.X_WP.translation().x() = x;
    RigPlacement X_WS;
    place(rig, pose, X_WS);
    fits.add(cost, X_WS);
  };
  add(0.3, 1.4e-4);
  add(0.0, 1e-4);
  add(-0.2, 1.2e-4);
  add(1.0, 1.6e-4);
  for (const double apart : fits.apart()) EXPECT_NEAR(apart, 0.3 + AlikeFits::kOwnError, 1e-12);
  // Dearer ones make room.
  for (std::size_t k = 0; k < 2 * AlikeFits::kMax; ++k) add(2.0, 9e-4);
  for (const double apart : fits.apart()) EXPECT_NEAR(apart, 0.3 + AlikeFits::kOwnError, 1e-12);
  for (std::size_t k = 0; k < AlikeFits::kMax; ++k) add(0.5, 0.5e-4);
  for (const double apart : fits.apart()) EXPECT_NEAR(apart, 0.0, 1e-12) << "others cost more";
  add(0.52, 0.49e-4);
  for (const double apart : fits.apart()) EXPECT_NEAR(apart, 0.02, 1e-12) << "the same place";
}

}  // namespace bent_start_test
}  // namespace abstand::tracking
