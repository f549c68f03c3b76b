// The free space of hidden limbs: against dense sampling of an arm's poses, walls of empty space, and time.
#include "tracking/tracker/hidden_space.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "tests/support/no_alloc.hpp"
#include "tests/tracking/tracker/small_camera.hpp"

namespace abstand::tracking {
namespace hidden_space_test {

using humanmodel::Joint;

constexpr SeenSegments kAll = (1u << kRigSegments) - 1u;
constexpr SeenSegments kNoForearm =
    kAll & ~(1u << index(RigSegment::kForearmLeft)) & ~(1u << index(RigSegment::kHandLeft));
constexpr double kSampled = 0.06;  // m, of the quantile of 128 samples on a sphere with a radius of 0.25 m

constexpr double kShareSampled = 0.06;  // of 128 samples, of which some are free, against all dense ones
constexpr double kRounding = 1e-12;

std::size_t at(Joint joint) { return static_cast<std::size_t>(joint); }

/// A person who stands over the origin and faces the camera, with hanging arms.
struct Stand {
  BodyRig rig = makeRig(humanmodel::makeHuman({}));
  RigPlacement X_WS;
  DepthCamera camera = smallCamera();
  DepthImage image;
  std::vector<std::uint8_t> is_person;
  BodyObservation seen;

  Stand() {
    RigPose pose;
    pose.X_WP.translation().z() = 0.95;
    place(rig, pose, X_WS);
    image = DepthImage(camera.width, camera.height);
    is_person.assign(image.z.size(), 0);
  }
  /// Depth (m) of a wall that fills the image, with the person's pixels in a strip of a few columns.
  void show(float wall) {
    for (std::size_t i = 0; i < image.z.size(); ++i) {
      image.z[i] = wall;
      const auto u = i % static_cast<std::size_t>(image.width);
      is_person[i] = u > 70 && u < 90;
      if (is_person[i]) image.z[i] = 2.4f;
    }
    const PersonImage person{&image, &camera, is_person};
    seen.update({&person, 1});
  }
};

/// Offsets from the estimate of wrists on the sphere about the elbow that are no more than 155 degrees from
/// the upper arm's direction and for which `is_free` holds at wrist and middle.
template <typename Free>
std::vector<Vector3d> denseOffsets(const Stand& stand, const Free& is_free) {
  const Transform& X_WU = stand.X_WS[index(RigSegment::kUpperArmLeft)];
  const Vector3d elbow = stand.X_WS[index(RigSegment::kForearmLeft)].translation();
  const Vector3d upper = (elbow - X_WU.translation()).normalized();
  const double length = stand.rig.p_joint[at(Joint::kWristLeft)].norm();
  const Vector3d wrist =
      stand.X_WS[index(RigSegment::kForearmLeft)] * stand.rig.p_joint[at(Joint::kWristLeft)];
  std::vector<Vector3d> offset;
  for (int i = 0; i < 200; ++i)
    for (int k = 0; k < 200; ++k) {
      const double z = (i + 0.5) / 100.0 - 1.0, a = 2.0 * kPi * k / 200.0, r = std::sqrt(1.0 - z * z);
      const Vector3d d(r * std::cos(a), r * std::sin(a), z);
      if (d.dot(upper) < std::cos(unit::deg(155.0))) continue;
      if (is_free(elbow + length * d) && is_free(elbow + 0.5 * length * d))
        offset.push_back(elbow + length * d - wrist);
    }
  return offset;
}

/// kShare quantile of their lengths.
template <typename Free>
double denseExtent(const Stand& stand, const Free& is_free) {
  std::vector<double> distance;
  for (const Vector3d& offset : denseOffsets(stand, is_free)) distance.push_back(offset.norm());
  std::sort(distance.begin(), distance.end());
  return distance.empty()
             ? kInfinity
             : distance[static_cast<std::size_t>(HiddenSpace::kShare * static_cast<double>(distance.size()))];
}

TEST(HiddenSpace, IsTheSphereOfAForearmOfWhichNothingIsKnown) {
  Stand stand;
  HiddenSpace space(stand.rig);
  space.update(stand.seen, stand.X_WS, kNoForearm);
  const double all = denseExtent(stand, [](const Vector3d&) { return true; });
  EXPECT_NEAR(space.extent()[at(Joint::kWristLeft)], all, kSampled);
  EXPECT_GT(space.extent()[at(Joint::kHandLeft)], all);
  EXPECT_EQ(space.extent()[at(Joint::kElbowLeft)], kInfinity);
  EXPECT_EQ(space.extent()[at(Joint::kWristRight)], kInfinity);
}

TEST(HiddenSpace, LeavesOutWhatACameraSeesToBeEmpty) {
  Stand stand;
  HiddenSpace space(stand.rig);
  // All but a strip of 20 columns before the trunk is empty: the arm would be behind the trunk.
  stand.show(5.0f);
  const auto is_free = [&](const Vector3d& p_W) {
    const Vector3d p_C = stand.camera.X_WC.inverse() * p_W;
    const double u = stand.camera.fx * p_C.x() / p_C.z() + stand.camera.cx;
    const double beside = std::max({0.0, 71.0 - u, u - 89.0}) * p_C.z() / stand.camera.fx;
    return beside <= HiddenSpace::kTolerance && (beside > 0.0 || p_C.z() > 2.4 - HiddenSpace::kTolerance);
  };
  space.update(stand.seen, stand.X_WS, kNoForearm);
  const double dense = denseExtent(stand, is_free);
  ASSERT_TRUE(std::isfinite(dense));
  EXPECT_NEAR(space.extent()[at(Joint::kWristLeft)], dense, 1.5 * kSampled);
  // The ellipsoid holds the same share as the ball, and is thinner: the strip is narrow.
  const Matrix3d& shape = space.shape()[at(Joint::kWristLeft)];
  std::size_t within = 0;
  const std::vector<Vector3d> offsets = denseOffsets(stand, is_free);
  for (const Vector3d& offset : offsets) within += offset.dot(shape.inverse() * offset) <= 1.0;
  EXPECT_GE(static_cast<double>(within),
            (HiddenSpace::kShare - kShareSampled) * static_cast<double>(offsets.size()));
  const Vector3d semi = Eigen::SelfAdjointEigenSolver<Matrix3d>(shape).eigenvalues().cwiseSqrt();
  EXPECT_GE(semi[0] + kRounding, HiddenSpace::kThin);
  EXPECT_LT(semi[0], 0.7 * dense);
  EXPECT_LT(semi.sum(), 3.0 * dense) << "the sum of the semi-axes is not above that of the ball";
}

TEST(HiddenSpace, KeepsWhatSomethingNearerHides) {
  Stand stand;
  HiddenSpace space(stand.rig);
  const double all = denseExtent(stand, [](const Vector3d&) { return true; });
  stand.show(1.5f);  // a wall between the camera and the person
  space.update(stand.seen, stand.X_WS, kNoForearm);
  EXPECT_NEAR(space.extent()[at(Joint::kWristLeft)], all, kSampled);
}

TEST(HiddenSpace, IsUnknownWhereNoSampleIsLeft) {
  Stand stand;
  HiddenSpace space(stand.rig);
  std::fill(stand.is_person.begin(), stand.is_person.end(), std::uint8_t{0});
  stand.show(5.0f);
  // The arm hangs on something a metre beside the strip.
  for (Transform& X : stand.X_WS) X.translation().y() += 1.0;
  testing::NoAlloc guard;
  space.update(stand.seen, stand.X_WS, kNoForearm);
  EXPECT_EQ(guard.count(), 0);
  EXPECT_EQ(space.extent()[at(Joint::kWristLeft)], kInfinity);
}

}  // namespace hidden_space_test
}  // namespace abstand::tracking
