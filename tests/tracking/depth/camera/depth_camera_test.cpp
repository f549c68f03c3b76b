// Camera files: what is read back, and what is refused.
#include <gtest/gtest.h>

#include "core/base/error.hpp"
#include "tests/support/random_pose.hpp"
#include "tracking/depth/camera/depth_camera.hpp"

namespace abstand::testing {
namespace depth_camera_test {

constexpr double kRounding = 1e-12;  // of poses through three angles

TEST(DepthCamera, RoundTrips) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    tracking::DepthCamera camera;
    camera.width = 320;
    camera.fx = 285.63 + 1e-9;
    camera.distortion << 0.1, -0.2, 0.001, 0.002, 0.05;
    camera.X_WC = randomPose(seed, 3.0);
    camera.spread = 1e-4 * static_cast<double>(seed);
    const tracking::DepthCamera again =
        tracking::parseDepthCamera(tracking::describeDepthCamera(camera), "camera.yaml");
    EXPECT_EQ(again.width, camera.width);
    EXPECT_EQ(again.height, camera.height);
    EXPECT_EQ(again.fx, camera.fx);
    EXPECT_EQ(again.distortion, camera.distortion);
    EXPECT_EQ(again.spread, camera.spread);
    EXPECT_LT((again.X_WC.matrix() - camera.X_WC.matrix()).cwiseAbs().maxCoeff(), kRounding) << seed;
  }
  // Straight up, where two of the angles turn about the same axis.
  tracking::DepthCamera camera;
  camera.X_WC = fromXyzRpy({1, 2, 3}, {0.3, kPi / 2, 0.2});
  const tracking::DepthCamera again =
      tracking::parseDepthCamera(tracking::describeDepthCamera(camera), "camera.yaml");
  EXPECT_LT((again.X_WC.matrix() - camera.X_WC.matrix()).cwiseAbs().maxCoeff(), 1e-7);
}

struct Wrong {
  const char* text;
  const char* message;
};

TEST(DepthCamera, ReportsErrorsWithPosition) {
  const std::string whole =
      "width: 640\nheight: 480\nfx: 580\nfy: 580\ncx: 319.5\ncy: 239.5\ndepth_scale: 1000\n";
  EXPECT_NO_THROW(tracking::parseDepthCamera(whole, "c.yaml"));
  for (const Wrong& wrong :
       {Wrong{"width: 640\n", "c.yaml:1:1: error: "}, Wrong{"width: 0\n", "c.yaml:1:8: error: "},
        Wrong{"- 1\n", "c.yaml:1:1: error: "}, Wrong{"breadth: 1\n", "breadth"}}) {
    try {
      tracking::parseDepthCamera(wrong.text, "c.yaml");
      ADD_FAILURE() << wrong.text;
    } catch (const ParseError& e) {
      EXPECT_NE(std::string(e.what()).find(wrong.message), std::string::npos) << e.what();
    }
  }
  for (const char* more :
       {"distortion: [1, 2]\n", "fx: 580\n", "T_WC: {xyz: [1, 2]}\n", "T_WC: {xyz: [.nan, 0, 0]}\n"})
    EXPECT_THROW(tracking::parseDepthCamera(whole + more, "c.yaml"), ParseError) << more;
}

TEST(DepthCamera, LooksAtTarget) {
  const Vector3d eye(3, 1, 1.5), target(0, 0, 1);
  const Transform X_WC = tracking::lookingAt(eye, target);
  EXPECT_TRUE(isPose(X_WC, kRounding));
  const Vector3d seen = X_WC.inverse() * target;
  EXPECT_LT((seen - Vector3d(0, 0, (target - eye).norm())).norm(), kRounding);
  EXPECT_LT((X_WC.inverse() * (target + Vector3d(0, 0, 0.1))).y(), 0.0);  // up is where v falls
  EXPECT_NEAR(X_WC.linear()(2, 0), 0.0, kRounding);                       // rows are level
  EXPECT_THROW(tracking::lookingAt(eye, eye), UsageError);
  EXPECT_THROW(tracking::lookingAt(eye, eye + Vector3d(0, 0, 1)), UsageError);
}

}  // namespace depth_camera_test
}  // namespace abstand::testing
