#include "tracking/recording/mirrored_person.hpp"

#include <gtest/gtest.h>

#include "core/base/error.hpp"
#include "humanmodel/human_model.hpp"
#include "humanmodel/joint_covariance.hpp"

namespace abstand::tracking {
namespace mirrored_person_test {

using humanmodel::Joint;

// m: sums of frames.
constexpr double kRounding = 1e-12;

/// Faces +y at (2, 3), raises the right hand while the left one hangs.
std::vector<humanmodel::SkeletonFrame> raisedHand() {
  std::vector<humanmodel::SkeletonFrame> frames;
  for (int i = 0; i < 5; ++i) {
    humanmodel::SkeletonFrame f;
    f.t = 0.1 * i;
    f.set(Joint::kPelvis, {2, 3, 1});
    f.set(Joint::kHipLeft, {1.9, 3, 1});
    f.set(Joint::kHipRight, {2.1, 3, 1});
    f.set(Joint::kHandLeft, {1.6, 3, 0.8});
    f.set(Joint::kHandRight, {2.4, 3.2, 0.8 + 0.2 * i}, humanmodel::JointState::kInferred);
    Matrix3d covariance = Vector3d(4e-4, 2e-4, 1e-4).asDiagonal();
    covariance(0, 1) = covariance(1, 0) = 1e-4;
    humanmodel::setCovariance(f, Joint::kHandRight, covariance);
    frames.push_back(f);
  }
  return frames;
}

TEST(MirroredPerson, SwapsHands) {
  auto frames = raisedHand();
  mirrorPerson(frames);
  for (int i = 0; i < 5; ++i) {
    const auto& f = frames[static_cast<std::size_t>(i)];
    EXPECT_TRUE(f[Joint::kHandLeft].isApprox(Vector3d(1.6, 3.2, 0.8 + 0.2 * i), kRounding));
    EXPECT_TRUE(f[Joint::kHandRight].isApprox(Vector3d(2.4, 3, 0.8), kRounding));
    EXPECT_TRUE(f[Joint::kPelvis].isApprox(Vector3d(2, 3, 1), kRounding)) << "stays in place";
    EXPECT_TRUE(f[Joint::kHipLeft].isApprox(Vector3d(1.9, 3, 1), kRounding)) << "faces the same way";
    EXPECT_EQ(f.state[static_cast<std::size_t>(Joint::kHandLeft)], humanmodel::JointState::kInferred);
    // Mirrored across x = 2: the product of x and y changes its sign.
    const Matrix3d C = humanmodel::covarianceOf(f, Joint::kHandLeft);
    EXPECT_NEAR(C(0, 0), 4e-4, kRounding);
    EXPECT_NEAR(C(0, 1), -1e-4, kRounding);
    EXPECT_NEAR(C(1, 1), 2e-4, kRounding);
    EXPECT_FALSE(f.has(Joint::kHead)) << "what is missing stays missing";
  }
}

TEST(MirroredPerson, MirrorsStatedTwist) {
  auto frames = raisedHand();
  // The person's left is -x here; the right hand is turned by 30 degrees about z.
  frames[0].lateral[static_cast<std::size_t>(Joint::kHandRight)] =
      Eigen::Vector3f(-std::sqrt(0.75f), 0.5f, 0.0f);
  mirrorPerson(frames);
  EXPECT_LT((frames[0].lateral[static_cast<std::size_t>(Joint::kHandLeft)] -
             Eigen::Vector3f(-std::sqrt(0.75f), -0.5f, 0.0f))
                .norm(),
            1e-6f)
      << "turned as far to the other side";
  EXPECT_TRUE(frames[0].lateral[static_cast<std::size_t>(Joint::kHandRight)].isZero());
}

TEST(MirroredPerson, MirroringTwiceIsIdentity) {
  const auto expected = raisedHand();
  auto frames = expected;
  mirrorPerson(frames);
  mirrorPerson(frames);
  for (std::size_t i = 0; i < frames.size(); ++i)
    for (std::size_t j = 0; j < humanmodel::kJointCount; ++j)
      if (expected[i].has(static_cast<Joint>(j))) {
        EXPECT_TRUE(frames[i].p[j].isApprox(expected[i].p[j], kRounding));
      }
}

TEST(MirroredPerson, RequiresBothSides) {
  std::vector<humanmodel::SkeletonFrame> frames(3);
  for (auto& f : frames) f.set(Joint::kHead, {0, 0, 1.7});
  EXPECT_THROW(mirrorPerson(frames), UsageError);
}

}  // namespace mirrored_person_test
}  // namespace abstand::tracking
