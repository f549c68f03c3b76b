#include "tests/tracking/depth/calibration/links_trial.hpp"

#include <algorithm>

#include "core/base/error.hpp"
#include "core/math/random.hpp"
#include "tests/tracking/depth/calibration/arm_view.hpp"
#include "tests/tracking/depth/calibration/pose_errors.hpp"

namespace abstand::testing {
namespace {

const Vector3d kArmMiddle(0.0, 0.1, 0.8);

}  // namespace

LinksTrial linksTrial(const LinksCase& c, std::uint64_t seed) {
  const PlainArm arm;
  Random random(seed, 11);
  const double yaw = random.between(-0.5, 0.9), pitch = random.between(0.1, 0.5);
  const Vector3d away(std::cos(yaw) * std::cos(pitch), std::sin(yaw) * std::cos(pitch), std::sin(pitch));
  const Vector3d eye = kArmMiddle + c.distance * away;
  const Vector3d side(-std::sin(yaw), std::cos(yaw), 0.0);
  tracking::DepthCamera camera = smallKinect(eye, kArmMiddle + c.aside * side);
  const Transform truth = camera.X_WC;
  std::vector<tracking::SurfaceView> views;
  for (int i = 0; i < c.images; ++i)
    views.push_back(armSeen(camera, arm.bodies,
                            PlainArm::at(c.images > 1 ? 0.4 + 1.6 * i / (c.images - 1) : 1.2),
                            1000 * seed + static_cast<std::uint64_t>(i)));
  camera.X_WC = wrong(truth, 0.1, unit::deg(10.0), seed);
  LinksTrial trial;
  try {
    trial.fit = tracking::fitPoseToSurfaces(camera, arm.bodies, views, seed);
  } catch (const UsageError& e) {
    trial.refusal = e.what();
    return trial;
  }
  trial.is_taken = true;
  const Transform off = trial.fit.X_WC * truth.inverse();
  trial.camera_error = (off * eye - eye).norm();
  for (int k = 0; k < 6; ++k) {
    const Vector3d p = kArmMiddle + (k % 2 ? -1.0 : 1.0) * Vector3d::Unit(k / 2);
    trial.near_error = std::max(trial.near_error, (off * p - p).norm());
  }
  return trial;
}

}  // namespace abstand::testing
