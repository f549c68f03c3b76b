// A live camera: a driver of our own plays what goes wrong.
#include <gtest/gtest.h>

#include "core/base/error.hpp"
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
  EXPECT_EQ(refusal("mm:1", "live:webcam"),
            "found the camera 'live:webcam', expected live:kinect, live:kinect:2 (the second), or "
            "live:kinect:SERIAL");
  EXPECT_EQ(refusal("mm:1", "live:kinect:2"),
            "live:kinect:2: error: found 1 Kinect, expected 2, each at a USB controller of its own");
  EXPECT_EQ(refusal("mm:1,mm:1", "live:kinect:A00362"),
            "live:kinect:A00362: error: found no Kinect with this serial number that can be opened, expected "
            "one not in use by another program, and access rights (on Debian: group plugdev)");
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

TEST(LiveDepth, NamesChooseACamera) {
  EXPECT_EQ(tracking::kinectOf("live:kinect"), tracking::KinectChoice());
  EXPECT_EQ(tracking::kinectOf("live:kinect:1"), tracking::KinectChoice());
  EXPECT_EQ(tracking::kinectOf("live:kinect:3"), (tracking::KinectChoice{3, ""}));
  EXPECT_EQ(tracking::kinectOf("live:kinect:A00362913543047A"),
            (tracking::KinectChoice{1, "A00362913543047A"}));
  for (const char* bad : {"live:", "live:kinect:", "live:kinect:0", "live:kinect2", "live:kinect:a b",
                          "live:kinect:01234567890123456789012345678901"})
    EXPECT_THROW(tracking::kinectOf(bad), UsageError) << bad;
  if (!loadDriver(ABSTAND_FAKE_FREENECT)) GTEST_SKIP() << "libfreenect.h";
  ::setenv("FAKE_KINECT", "mm:2,mm:5", 1);
  for (const auto& [name, images] :
       {std::pair("live:kinect", 2u), std::pair("live:kinect:2", 5u), std::pair("live:kinect:KINECT2", 5u)}) {
    tracking::LiveDepth camera(name, {});
    EXPECT_EQ(watch(camera).size() + camera.dropped(), images) << name;
  }
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
