// Properties of posing with all joints there.
#include "humanmodel/poser.hpp"

#include <gtest/gtest.h>

#include "tests/humanmodel/skeletons.hpp"
#include "tests/support/no_alloc.hpp"

namespace abstand::humanmodel {
namespace poser_test {

using testing::largestShift;
using testing::largestTurn;
using testing::person;
using testing::walking;

// Positions of about 1 m through a dozen products in double.
constexpr double kRounding = 1e-12;
// Joints of neighbours coincide: what the poser promises.
constexpr double kCoincide = 1e-9;

Vector3d onPart(const HumanPose& pose, BodyPart part, const Vector3d& p_P) {
  return pose.X_WP[index(part)] * p_P;
}

void expectRigid(const HumanPose& pose) {
  for (std::size_t i = 0; i < kBodyPartCount; ++i)
    EXPECT_TRUE(isPose(pose.X_WP[i], kRounding)) << partName(static_cast<BodyPart>(i));
}

void expectSame(const HumanPose& a, const HumanPose& b, double tolerance = kRounding) {
  for (std::size_t i = 0; i < kBodyPartCount; ++i)
    EXPECT_LT((a.X_WP[i].matrix() - b.X_WP[i].matrix()).cwiseAbs().maxCoeff(), tolerance)
        << partName(static_cast<BodyPart>(i));
}

TEST(Poser, RestFrameGivesRestPose) {
  for (const HumanPreset preset : {HumanPreset::kThesis, HumanPreset::kAnthropometric})
    for (const bool follow : {false, true}) {
      const HumanModel m = person(1.75, preset);
      Poser poser(m, follow);
      HumanPose pose;
      for (int repeat = 0; repeat < 3; ++repeat) {
        poser.pose(m.rest, pose);
        for (const HumanPart& p : m.parts) {
          const std::size_t i = index(p.part);
          EXPECT_LT((pose.X_WP[i].linear() - Matrix3d::Identity()).cwiseAbs().maxCoeff(), kRounding)
              << partName(p.part);
          EXPECT_LT((pose.X_WP[i].translation() - (m.rest[p.proximal] - p.p_proximal)).norm(), kRounding)
              << partName(p.part);
          EXPECT_EQ(pose.state[i], PartState::kTracked);
          EXPECT_EQ(pose.age[i], 0.0);
        }
      }
    }
}

TEST(Poser, KeepsSharedJointsAndRecordedDirections) {
  const HumanModel m = person(1.9);
  Poser poser(m);
  HumanPose pose;
  for (double t = 0.0; t < 5.0; t += 0.05) {
    const SkeletonFrame frame = walking(t);
    poser.pose(frame, pose);
    expectRigid(pose);
    for (const auto& [parent, child] : adjacentParts()) {
      const HumanPart &a = m.part(parent), &b = m.part(child);
      const Joint joint = child == BodyPart::kHead ? Joint::kNeck : b.proximal;
      // The same joint reached along either part; the torso's own joints are those of the rest pose.
      const Vector3d on_parent =
          joint == a.distal ? a.p_distal : m.rest[joint] - (m.rest[a.proximal] - a.p_proximal);
      const Vector3d on_child = child == BodyPart::kHead ? b.p_distal : b.p_proximal;
      EXPECT_LT((onPart(pose, parent, on_parent) - onPart(pose, child, on_child)).norm(), kCoincide)
          << partName(parent) << " " << partName(child);
    }
    for (const HumanPart& p : m.parts) {
      if (p.part == BodyPart::kTorso) continue;  // its bone starts at the middle of the hips, below
      const Vector3d bone = onPart(pose, p.part, p.p_distal) - onPart(pose, p.part, p.p_proximal);
      EXPECT_LT((bone.normalized() - (frame[p.distal] - frame[p.proximal]).normalized()).norm(), kRounding)
          << partName(p.part);
      EXPECT_NEAR(bone.norm(), (p.p_distal - p.p_proximal).norm(), kRounding);
    }
    const Vector3d hips = 0.5 * (frame[Joint::kHipLeft] + frame[Joint::kHipRight]);
    EXPECT_LT((pose.X_WP[0].linear().col(2) - (frame[Joint::kNeck] - hips).normalized()).norm(), kRounding);
  }
}

TEST(Poser, ModelsOfAnySizeStandOnFloor) {
  for (const double height : {1.4, 1.62, 2.0}) {
    for (const double floor : {0.0, -0.9}) {
      const HumanModel m = person(height);
      SkeletonFrame frame = person(1.62).rest;
      for (Vector3d& p : frame.p) p += Vector3d(3.0, -2.0, floor);
      Poser poser(m, false, floor);
      HumanPose pose;
      poser.pose(frame, pose);
      for (const BodyPart foot : {BodyPart::kFootLeft, BodyPart::kFootRight}) {
        const double sole = (pose.X_WP[index(foot)] * Vector3d(0, 0, -0.5 * m.part(foot).depth)).z();
        EXPECT_NEAR(sole, floor, kRounding);
      }
      EXPECT_NEAR(onPart(pose, BodyPart::kHead, m.part(BodyPart::kHead).p_proximal).z(), floor + height,
                  kRounding);
      EXPECT_NEAR((pose.X_WP[0].translation() - m.rest[Joint::kPelvis]).x(), 3.0, kRounding);
    }
  }
}

TEST(Poser, CalibrationDecouplesHipsFromLegNoise) {
  const HumanModel m = person(1.9);
  std::vector<SkeletonFrame> recording(101, person(1.62).rest);
  recording[50].set(Joint::kKneeLeft, recording[0][Joint::kKneeLeft] + Vector3d(0.2, 0.0, 0.0));
  Poser poser(m);
  poser.calibrate(recording);
  HumanPose calm, noisy;
  poser.pose(recording[0], calm);
  poser.pose(recording[50], noisy);
  EXPECT_LT((calm.X_WP[0].translation() - noisy.X_WP[0].translation()).norm(), kRounding);
  poser.reset();
  poser.pose(recording[50], noisy);
  EXPECT_LT((calm.X_WP[0].translation() - noisy.X_WP[0].translation()).norm(), kRounding);
}

TEST(Poser, CalibrationPutsSolesOnFloorForAnyAnkleHeight) {
  const HumanModel m = person(1.9);
  for (const double floor : {0.0, 0.4})
    for (const double ankle : {0.02, 0.07, 0.15}) {
      std::vector<SkeletonFrame> recording(40, person(1.62).rest);
      const double up = floor + ankle - recording[0][Joint::kAnkleLeft].z();
      for (SkeletonFrame& frame : recording)
        for (Vector3d& p : frame.p) p.z() += up;
      Poser poser(m, false, floor);
      poser.calibrate(recording);
      HumanPose pose;
      poser.pose(recording[0], pose);
      const double half_height = 0.5 * m.part(BodyPart::kFootLeft).depth;
      EXPECT_NEAR(pose.X_WP[index(BodyPart::kFootLeft)].translation().z() - half_height, floor, kRounding);
    }
}

TEST(Poser, FollowedJointsKeepRecordedPositions) {
  const HumanModel m = person(1.62);  // as tall as the recorded person
  Poser poser(m, true);
  HumanPose pose;
  for (double t = 0.0; t < 3.0; t += 0.1) {
    const SkeletonFrame frame = walking(t);
    poser.pose(frame, pose);
    expectRigid(pose);
    for (const HumanPart& p : m.parts) {
      if (p.part == BodyPart::kTorso) continue;
      EXPECT_LT((onPart(pose, p.part, p.p_proximal) - frame[p.proximal]).norm(), kCoincide)
          << partName(p.part);
      EXPECT_LT((onPart(pose, p.part, p.p_distal) - frame[p.distal]).norm(), kCoincide) << partName(p.part);
    }
  }
  // With other lengths a limb's error is the same at both ends.
  const HumanModel tall = person(1.9);
  Poser other(tall, true);
  const SkeletonFrame frame = walking(1.0);
  other.pose(frame, pose);
  const HumanPart& calf = tall.part(BodyPart::kCalfLeft);
  EXPECT_NEAR((onPart(pose, calf.part, calf.p_proximal) - frame[calf.proximal]).norm(),
              (onPart(pose, calf.part, calf.p_distal) - frame[calf.distal]).norm(), kRounding);
}

TEST(Poser, IsInvariantUnderRigidMotion) {
  const HumanModel m = person(1.9);
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Transform X = Transform::Identity();
    X.linear() =
        Eigen::AngleAxisd(2 * kPi * testing::randomUnit(seed, 1), Vector3d::UnitZ()).toRotationMatrix();
    X.translation() = Vector3d(testing::randomUnit(seed, 2), testing::randomUnit(seed, 3), 0.0);
    Poser here(m), there(m);
    HumanPose a, b;
    for (double t = 0.0; t < 1.0; t += 0.1) {
      SkeletonFrame frame = walking(t);
      here.pose(frame, a);
      for (Vector3d& p : frame.p) p = X * p;
      there.pose(frame, b);
      for (Transform& X_WP : a.X_WP) X_WP = X * X_WP;
      expectSame(a, b);
    }
  }
}

TEST(Poser, MirroredInputGivesMirroredOutput) {
  const Matrix3d M = Vector3d(1.0, -1.0, 1.0).asDiagonal();
  const HumanModel m = person(1.8);
  Poser poser(m), mirrored(m);
  HumanPose a, b;
  for (double t = 0.0; t < 3.0; t += 0.1) {
    const SkeletonFrame frame = walking(t);
    SkeletonFrame mirror = frame;
    for (std::size_t j = 0; j < kJointCount; ++j) {
      // The left arm's joints stand four before the right arm's, and so do the legs'.
      const bool left = (j >= 6 && j < 10) || (j >= 14 && j < 18), right = (j >= 10 && j < 14) || j >= 18;
      mirror.p[left ? j + 4 : right ? j - 4 : j] = M * frame.p[j];
    }
    poser.pose(frame, a);
    mirrored.pose(mirror, b);
    for (std::size_t i = 0; i < kBodyPartCount; ++i) {
      const int side = sideOf(static_cast<BodyPart>(i));
      const Transform& X = b.X_WP[side > 0 ? i + 1 : side < 0 ? i - 1 : i];
      EXPECT_LT((X.linear() - M * a.X_WP[i].linear() * M).cwiseAbs().maxCoeff(), kRounding);
      EXPECT_LT((X.translation() - M * a.X_WP[i].translation()).norm(), kRounding);
    }
  }
}

TEST(Poser, OneMillimetreJitterMovesPartsLittle) {
  constexpr double kJitter = 1e-3;
  // A bone's end moves by the jitters of the chain below it; the shortest bone, the head's, is 0.2 m long,
  // and a bend of 20 degrees gives the hinge a lever of a third of the forearm.
  constexpr double kMaxTurn = 0.06, kMaxShift = 0.025;
  const HumanModel m = person(1.75);
  std::uint64_t stream = 0;
  const auto shaken = [&](SkeletonFrame frame, std::uint64_t seed) {
    for (Vector3d& p : frame.p)
      for (int i = 0; i < 3; ++i)
        p[i] += kJitter * (2.0 * testing::randomUnit(seed, ++stream) - 1.0) / std::sqrt(3.0);
    return frame;
  };
  for (const double t : {-1.0, 0.0, 0.4, 1.1}) {
    const SkeletonFrame frame = t < 0.0 ? person(1.62).rest : walking(t);
    Poser calm(m);
    HumanPose reference, pose;
    calm.pose(frame, reference);
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
      Poser fresh(m);
      fresh.pose(shaken(frame, seed), pose);
      EXPECT_LT(largestTurn(reference, pose), kMaxTurn);
      EXPECT_LT(largestShift(reference, pose), kMaxShift);
    }
  }
}

TEST(Poser, AllocatesNothing) {
  const HumanModel m = person();
  Poser poser(m);
  HumanPose pose;
  std::vector<SkeletonFrame> frames;
  for (int i = 0; i < 20; ++i) frames.push_back(walking(0.1 * i));
  testing::drop(frames[3], Joint::kHandLeft);
  testing::drop(frames[4], Joint::kKneeLeft);
  testing::drop(frames[5], Joint::kPelvis);
  testing::drop(frames[5], Joint::kHipLeft);
  frames[6].p[0].x() = kNaN;
  frames[7] = SkeletonFrame{};
  const testing::NoAlloc counter;
  for (const SkeletonFrame& f : frames) poser.pose(f, pose);
  EXPECT_EQ(counter.count(), 0);
}

}  // namespace poser_test
}  // namespace abstand::humanmodel
