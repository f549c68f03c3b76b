// Where the floor is assumed that no image shows.
#include "tracking/tracker/camera_stand.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/tracking/tracker/small_camera.hpp"
#include "tracking/tracker/stature.hpp"

namespace abstand::tracking {
namespace camera_stand_test {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr double kEye = 1.0;    // m, of a level camera above the true floor
constexpr double kNear = 0.05;  // m, some rows of the image, and points below the floor's substitute

/// Its pose is to be found.
DepthCamera unplacedCamera() {
  DepthCamera camera = smallCamera();
  camera.X_WC = Transform::Identity();
  return camera;
}

/// A trunk with head, `height` (m) high, at a distance of `z` (m), in front of nothing.
DepthImage personAt(double z, double height) {
  const DepthCamera camera = unplacedCamera();
  DepthImage image(camera.width, camera.height);
  for (int v = 0; v < camera.height; ++v) {
    for (int u = 0; u < camera.width; ++u) {
      const Vector3d p_C = camera.at(u, v, z);
      const double up = kEye - p_C.y(), half = up > height - 0.25 ? 0.09 : 0.22;
      if (std::abs(p_C.x()) < half && up > 0.0 && up < height)
        image.z[static_cast<std::size_t>(v * image.width + u)] = static_cast<float>(z);
    }
  }
  return image;
}

struct Decision {
  double height;  ///< m, of the camera
  std::string reason;
};

Decision decide(const DepthImage& image, std::optional<double> stature = {}) {
  CameraStand stand(unplacedCamera(), stature);
  for (int i = 0; !stand.see(i / 30.0, image) && i < 30;) ++i;
  return {stand.X_WC().translation().z(), stand.reason()};
}

TEST(CameraStand, FloorIsAtLowestPointOfWholePerson) {
  const Decision decision = decide(personAt(3.0, 1.60));
  EXPECT_NEAR(decision.height, kEye, kNear);
  EXPECT_THAT(decision.reason, HasSubstr("lowest visible point"));
}

TEST(CameraStand, FloorIsOneStatureBelowHeadOfCutOffPerson) {
  // At 1.8 m, the lowest row is 0.25 m above the floor.
  const DepthImage image = personAt(1.8, 1.70);
  const Decision usual = decide(image);
  EXPECT_NEAR(usual.height, kEye, kNear);
  EXPECT_THAT(usual.reason, HasSubstr("feet are below the image"));
  EXPECT_THAT(usual.reason, HasSubstr("z = 1.70 m"));
  EXPECT_NEAR(decide(personAt(1.8, 1.55)).height, kEye + Stature::kUsual - 1.55, kNear);
}

TEST(CameraStand, GivenStatureDecides) {
  const Decision decision = decide(personAt(1.8, 1.55), 1.55);
  EXPECT_NEAR(decision.height, kEye, kNear);
  EXPECT_THAT(decision.reason, HasSubstr("z = 1.55 m"));
}

// A stature that is too small would put the floor above what is seen.
TEST(CameraStand, FloorIsNeverAbovePerson) {
  constexpr double kDistance = 2.3;  // m: the lowest row is 5 cm above the floor
  const Decision decision = decide(personAt(kDistance, 1.70), 1.30);
  EXPECT_NEAR(decision.height, kDistance * 119.5 / 290.0, kNear);
  EXPECT_THAT(decision.reason, Not(HasSubstr("feet are below")));
}

}  // namespace camera_stand_test
}  // namespace abstand::tracking
