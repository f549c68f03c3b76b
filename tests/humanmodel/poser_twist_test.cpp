// Twist about the bones: hinges, straight limbs, no flips.
#include <gtest/gtest.h>

#include "humanmodel/segment_frame.hpp"
#include "tests/humanmodel/skeletons.hpp"

namespace abstand::humanmodel {
namespace poser_twist_test {

using enum Joint;
using testing::bend;
using testing::person;

constexpr double kRounding = 1e-12;
const Vector3d kX = Vector3d::UnitX(), kY = Vector3d::UnitY(), kZ = Vector3d::UnitZ();

/// Turns of the parts from step to step of a motion, the largest of them, rad.
template <class Motion>
double largestStep(const HumanModel& m, int steps, Motion motion) {
  Poser poser(m);
  HumanPose last, pose;
  double largest = 0.0;
  for (int i = 0; i <= steps; ++i) {
    SkeletonFrame frame = motion(static_cast<double>(i) / steps);
    frame.t = 0.01 * i;
    poser.pose(frame, pose);
    if (i > 0) largest = std::max(largest, testing::largestTurn(last, pose));
    last = pose;
  }
  return largest;
}

TEST(PoserTwist, HingeDefinesTwistOfBentArm) {
  const HumanModel m = person();
  for (const double yaw : {-1.2, 0.0, 0.7}) {
    SkeletonFrame frame = m.rest;
    bend(frame, kElbowLeft, -kY, unit::deg(80), {kWristLeft, kHandLeft});
    bend(frame, kShoulderLeft, kZ, yaw,
         {kElbowLeft, kWristLeft, kHandLeft});  // twist of the hanging upper arm
    Poser poser(m);
    HumanPose pose;
    poser.pose(frame, pose);
    const Vector3d hinge = Eigen::AngleAxisd(yaw, kZ) * kY;
    for (const BodyPart part : {BodyPart::kBicepsLeft, BodyPart::kForearmLeft, BodyPart::kHandLeft})
      EXPECT_LT((pose.X_WP[index(part)].linear().col(1) - hinge).norm(), kRounding) << partName(part) << yaw;
  }
}

TEST(PoserTwist, KneesBendOppositeToElbows) {
  const HumanModel m = person();
  SkeletonFrame frame = m.rest;
  bend(frame, kKneeRight, kY, unit::deg(60), {kAnkleRight, kToeRight});
  Poser poser(m);
  HumanPose pose;
  poser.pose(frame, pose);
  for (const BodyPart part : {BodyPart::kThighRight, BodyPart::kCalfRight, BodyPart::kFootRight})
    EXPECT_LT((pose.X_WP[index(part)].linear().col(1) - kY).norm(), kRounding) << partName(part);
}

TEST(PoserTwist, NoFlipWhenArmSweepsThroughStraight) {
  const HumanModel m = person();
  // From 90 degrees of bend through straight to 60 degrees the wrong way, as a noisy tracker may show it,
  // while the arm swings in three directions.
  for (const Vector3d& swing : {kX, Vector3d(-kY), Vector3d(kX - kY)}) {
    constexpr int kSteps = 600;
    const double step = largestStep(m, kSteps, [&](double s) {
      SkeletonFrame frame = m.rest;
      bend(frame, kElbowLeft, -kY, unit::deg(90 - 150 * s), {kWristLeft, kHandLeft});
      bend(frame, kShoulderLeft, swing, unit::deg(70 * s), {kElbowLeft, kWristLeft, kHandLeft});
      return frame;
    });
    // 150 degrees of bend and 70 of swing in 600 steps are 0.37 degrees a step; twice that for the blend.
    EXPECT_LT(step, 2.0 * unit::deg(220.0 / kSteps));
  }
}

TEST(PoserTwist, NoFlipWhenHingeTurnsWhileStraight) {
  const HumanModel m = person();
  // Straight, then bent sideways: the twist turns from the carried to the new hinge over the bend, not at
  // once.
  const double step = largestStep(m, 1000, [&](double s) {
    SkeletonFrame frame = m.rest;
    bend(frame, kElbowRight, Vector3d(-kX - 0.2 * kY), unit::deg(60 * s), {kWristRight, kHandRight});
    return frame;
  });
  EXPECT_LT(step, unit::deg(10));
}

TEST(PoserTwist, NoiseDoesNotTwistStraightArm) {
  const HumanModel m = person();
  std::uint64_t k = 0;
  const double step = largestStep(m, 500, [&](double) {
    SkeletonFrame frame = m.rest;
    for (Vector3d& p : frame.p)
      for (int i = 0; i < 3; ++i) p[i] += 2e-3 * (testing::randomUnit(5, ++k) - 0.5);
    return frame;
  });
  // 1 mm at both ends of the shortest lines (between the hips 0.2 m, along the foot 0.2 m).
  EXPECT_LT(step, unit::deg(3));
}

TEST(PoserTwist, StraightArmTurnsWithBody) {
  const HumanModel m = person();
  Poser poser(m);
  HumanPose pose;
  for (int i = 0; i <= 180; ++i) {
    SkeletonFrame frame = m.rest;
    const Matrix3d R = Eigen::AngleAxisd(unit::deg(i), kZ).toRotationMatrix();
    for (Vector3d& p : frame.p) p = R * p;
    poser.pose(frame, pose);
    EXPECT_LT((pose.X_WP[index(BodyPart::kHandLeft)].linear() - R).norm(), kRounding);
  }
}

TEST(SegmentFrame, CarriedAxesStayOrthogonal) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const Matrix3d R = testing::randomPose(seed).linear();
    const Vector3d b = testing::randomPose(seed + 1000).linear().col(0);
    const Vector3d y = carriedY(R, kZ, b);
    EXPECT_NEAR(y.norm(), 1.0, 1e-9);
    EXPECT_NEAR(y.dot(b), 0.0, 1e-9);
    const Matrix3d moved = frameAlong(kZ, b, y);
    EXPECT_LT((moved.col(2) - b).norm(), kRounding);
    EXPECT_NEAR(moved.determinant(), 1.0, kRounding);
  }
  const Matrix3d I = Matrix3d::Identity();
  EXPECT_LT((carriedY(I, kZ, -kZ) - kY).norm(), kRounding) << "straight opposite: half a turn about y";
  EXPECT_LT((carriedY(I, kZ, kZ) - kY).norm(), kRounding);
}

TEST(SegmentFrame, HingeBlendsInWithBend) {
  const auto turned = [](double sine, const Vector3d& axis, bool either) {
    return turnedToHinge(kY, kZ, sine * axis, either);
  };
  EXPECT_EQ(turned(0.1, kX, true), kY);
  EXPECT_LT((turned(0.9, kX, true) - kX).norm(), kRounding);
  EXPECT_LT((turned(0.9, -kX, true) + kX).norm(), kRounding);
  EXPECT_LT((turned(0.9, -kY, true) - kY).norm(), kRounding) << "a line, not an arrow";
  EXPECT_LT((turned(0.9, -kY, false) + kY).norm(), kRounding);
  const double part = std::acos(turned(0.25, kX, true).dot(kY));
  EXPECT_GT(part, unit::deg(20));
  EXPECT_LT(part, unit::deg(70));
}

/// y axis that a poser gives a part in its first frame.
Vector3d yOf(const HumanModel& m, const SkeletonFrame& frame, BodyPart part) {
  Poser poser(m);
  HumanPose pose;
  poser.pose(frame, pose);
  return pose.X_WP[index(part)].linear().col(1);
}

TEST(PoserTwist, StatedAxisTurnsAPartAboutItsBone) {
  const HumanModel m = person();
  for (const auto& [part, joint] : {std::pair{BodyPart::kBicepsLeft, kElbowLeft},
                                    {BodyPart::kForearmLeft, kWristLeft},
                                    {BodyPart::kHandRight, kHandRight},
                                    {BodyPart::kHead, kHeadTop},
                                    {BodyPart::kFootRight, kToeRight}}) {
    SkeletonFrame frame = m.rest;
    const HumanPart& bone = m.part(part);
    const Vector3d along = (frame[bone.proximal] - frame[bone.distal]).normalized();
    const Vector3d y = Eigen::AngleAxisd(unit::deg(50), along) * kY;
    // A part of it along the bone does not count.
    frame.lateral[static_cast<std::size_t>(joint)] = (y + 0.3 * along).normalized().cast<float>();
    EXPECT_LT((yOf(m, frame, part) - y).norm(), 1e-6) << partName(part) << ": a float has seven digits";
    for (const Vector3d& useless : {along, Vector3d(Vector3d::Constant(kNaN)), Vector3d(Vector3d::Zero())}) {
      frame.lateral[static_cast<std::size_t>(joint)] = useless.cast<float>();
      EXPECT_LT((yOf(m, frame, part) - kY).norm(), kRounding) << partName(part);
    }
  }
}

TEST(PoserTwist, BendOfTheElbowPrecedesTheStatedAxisOfTheUpperArm) {
  const HumanModel m = person();
  SkeletonFrame frame = m.rest;
  const Eigen::Vector3f y = (Eigen::AngleAxisd(unit::deg(30), kZ) * kY).cast<float>();
  frame.lateral[static_cast<std::size_t>(kElbowLeft)] = y;
  bend(frame, kElbowLeft, -kY, unit::deg(80), {kWristLeft, kHandLeft});
  EXPECT_LT((yOf(m, frame, BodyPart::kBicepsLeft) - kY).norm(), 1e-6);
}

}  // namespace poser_twist_test
}  // namespace abstand::humanmodel
