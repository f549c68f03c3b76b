// A live camera: libfreenect's own fake plays a recording.
#include <gtest/gtest.h>

#include "core/base/output_file.hpp"
#include "tests/support/paths.hpp"
#include "tests/tracking/depth/live/live_frames.hpp"
#include "tracking/depth/formats/freenect_depth.hpp"

namespace abstand::testing {
namespace fakenect_test {

/// A few images of a slope that rises, as `record` dumps them.
void record(const std::filesystem::path& folder, int count) {
  std::string index;
  for (int i = 0; i < count; ++i) {
    tracking::DepthImage image(tracking::kKinectWidth, tracking::kKinectHeight);
    for (int v = 0; v < image.height; ++v)
      for (int u = 0; u < image.width; ++u)
        image.at(u, v) =
            u > 630 ? 0.0f : 0.8f + 0.005f * static_cast<float>(v) + 0.1f * static_cast<float>(i);
    char name[64];
    std::snprintf(name, sizeof name, "d-%.6f-%d.pgm", 100.0 + 0.04 * i, i);
    writeFile(folder / name, tracking::freenectDump(image));
    index += std::string(name) + "\n";
  }
  writeFile(folder / "INDEX.txt", index);
}

TEST(Fakenect, DriverMatchesFileReader) {
  if (!loadDriver(ABSTAND_FAKENECT)) GTEST_SKIP() << "libfreenect0.5, which has fakenect";
  ScratchFolder folder;
  constexpr int kCount = 6;
  record(folder.path(), kCount);
  ::setenv("FAKENECT_PATH", folder.path().c_str(), 1);
  tracking::LiveDepth camera(tracking::kKinectSource, {});
  const std::vector<tracking::LiveFrame> frames = watch(camera);
  ASSERT_FALSE(frames.empty());
  EXPECT_EQ(frames.size() + camera.dropped(), static_cast<std::size_t>(kCount));
  EXPECT_EQ(camera.ended(), "found the camera disconnected after 6 images, expected it to stay plugged in");

  const auto file = tracking::openDepthStream(folder.path());
  EXPECT_EQ(file->size(), static_cast<std::size_t>(kCount));
  EXPECT_EQ(file->camera().fx, camera.camera().fx);
  EXPECT_EQ(file->facts().camera_reason, camera.facts().camera_reason);
  tracking::DepthFrame read;
  for (const tracking::LiveFrame& live : frames) {
    bool found = false;
    while (!found && file->next(read)) found = read.image.z == live.frame.image.z;
    EXPECT_TRUE(found) << "an image that is not in the files, or not in their order";
  }
}

}  // namespace fakenect_test
}  // namespace abstand::testing
