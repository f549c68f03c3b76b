// A live camera: a driver of our own plays what goes wrong.
#include <gtest/gtest.h>

#include "tests/tracking/depth/live/live_frames.hpp"

namespace abstand::testing {
namespace live_depth_test {

std::string refusal(const char* role, const std::string& name = tracking::kKinectSource,
                    const tracking::DepthStreamOptions& options = {}) {
  ::setenv("FAKE_KINECT", role, 1);
  try {
    tracking::LiveDepth camera(name, options);
  } catch (const std::exception& e) {
    return e.what();
  }
  return "nothing was refused";
}

TEST(LiveDepth, ReportsWhyCameraIsUnavailable) {
  if (!loadDriver(ABSTAND_FAKE_FREENECT)) GTEST_SKIP() << "libfreenect.h";
  EXPECT_EQ(refusal("no_usb"),
            "live:kinect: error: found no USB access for libfreenect, expected a machine with a Kinect v1 "
            "at a USB port");
  EXPECT_EQ(refusal("no_camera"),
            "live:kinect: error: found no camera, expected a Kinect v1 at a USB port, with its power supply");
  EXPECT_EQ(refusal("locked"),
            "live:kinect: error: found a Kinect that cannot be opened (Could not open camera: "
            "LIBUSB_ERROR_ACCESS), "
            "expected one not in use by another program, and access rights (on Debian: group "
            "plugdev)");
  EXPECT_EQ(refusal("mm:1", "live:webcam"), "found the camera 'live:webcam', expected live:kinect");
  tracking::DepthStreamOptions rate;
  rate.rate = 30.0;
  EXPECT_EQ(refusal("mm:1", tracking::kKinectSource, rate),
            "--rate: found with a live camera, expected a recording");
}

TEST(LiveDepth, KeepsFramesReceivedBeforeDisconnect) {
  if (!loadDriver(ABSTAND_FAKE_FREENECT)) GTEST_SKIP() << "libfreenect.h";
  ::setenv("FAKE_KINECT", "mm:7", 1);
  tracking::LiveDepth camera(tracking::kKinectSource, {});
  EXPECT_EQ(camera.facts().notes.front(), "millimetres by the camera's own calibration");
  EXPECT_FALSE(camera.facts().pose_known);
  const std::vector<tracking::LiveFrame> frames = watch(camera);
  EXPECT_EQ(frames.size() + camera.dropped(), 7u);
  ASSERT_FALSE(frames.empty());
  // The newest wins: whatever was dropped, the last one was not.
  EXPECT_FLOAT_EQ(frames.back().frame.image.z.back(), 0.706f);
  for (const tracking::LiveFrame& f : frames) {
    EXPECT_EQ(f.frame.image.z[0], 0.0f);
    EXPECT_EQ(f.frame.image.z[1], 0.0f) << "65535 is no depth";
  }
  for (std::size_t i = 1; i < frames.size(); ++i) {
    EXPECT_GT(frames[i].frame.t, frames[i - 1].frame.t);
    EXPECT_GT(frames[i].frame.image.z.back(), frames[i - 1].frame.image.z.back());
  }
  EXPECT_EQ(camera.ended(),
            "found the camera disconnected after 7 images (USB camera marked dead, stopping streams), "
            "expected it to stay "
            "plugged in");
  tracking::LiveFrame none;
  EXPECT_EQ(camera.next(none, 0.0), tracking::LiveDepth::Outcome::kEnded) << "it stays ended";
}

TEST(LiveDepth, WaitsAtMostTimeout) {
  if (!loadDriver(ABSTAND_FAKE_FREENECT)) GTEST_SKIP() << "libfreenect.h";
  ::setenv("FAKE_KINECT", "silent", 1);
  tracking::LiveDepth camera(tracking::kKinectSource, {});
  tracking::LiveFrame frame;
  EXPECT_EQ(camera.next(frame, 0.02), tracking::LiveDepth::Outcome::kNothingYet);
  EXPECT_EQ(camera.ended(), "");
}

TEST(LiveDepth, CorrectsMirroredImages) {
  if (!loadDriver(ABSTAND_FAKE_FREENECT)) GTEST_SKIP() << "libfreenect.h";
  ::setenv("FAKE_KINECT", "mm:1", 1);
  tracking::DepthStreamOptions options;
  options.mirror = true;
  tracking::LiveDepth camera(tracking::kKinectSource, options);
  const std::vector<tracking::LiveFrame> frames = watch(camera);
  ASSERT_EQ(frames.size(), 1u);
  EXPECT_EQ(frames[0].frame.image.at(639, 0), 0.0f);
  EXPECT_GT(frames[0].frame.image.at(0, 0), 0.0f);
}

}  // namespace live_depth_test
}  // namespace abstand::testing
