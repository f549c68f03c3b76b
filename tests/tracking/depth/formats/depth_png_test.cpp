// Depth images on disk.
#include "tracking/depth/formats/depth_png.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <limits>

#include "core/base/error.hpp"
#include "core/base/text_file.hpp"
#include "tests/support/paths.hpp"

namespace abstand::testing {
namespace depth_png_test {

TEST(DepthPng, RoundTripsWholeUnits) {
  const ScratchFolder folder;
  tracking::DepthImage image(7, 3);
  image.at(0, 0) = 1.2345f;
  image.at(6, 2) = 65.535f;
  image.at(1, 1) = 65.6f;  // beyond 16 bits
  image.at(2, 1) = std::numeric_limits<float>::quiet_NaN();
  image.at(3, 1) = -1.0f;
  const auto file = folder.path() / "d.png";
  tracking::saveDepthPng(image, 1000.0, file);
  const tracking::DepthImage again = tracking::loadDepthPng(file, 1000.0);
  ASSERT_EQ(again.width, 7);
  ASSERT_EQ(again.height, 3);
  EXPECT_NEAR(again.at(0, 0), 1.2345, 0.0005 + 1e-6);
  EXPECT_NEAR(again.at(6, 2), 65.535, 1e-5);
  for (int u = 1; u <= 3; ++u) EXPECT_EQ(again.at(u, 1), 0.0f) << u;
}

TEST(DepthPng, RejectsNonDepthImages) {
  const ScratchFolder folder;
  const auto file = folder.path() / "d.png";
  tracking::saveDepthPng(tracking::DepthImage(20, 20), 1000.0, file);
  const std::string whole = readFile(file);
  const auto refused = [&](const std::string& bytes, const char* message) {
    std::ofstream(file, std::ios::binary) << bytes;
    try {
      tracking::loadDepthPng(file, 1000.0);
      ADD_FAILURE() << message;
    } catch (const ParseError& e) {
      EXPECT_NE(std::string(e.what()).find(message), std::string::npos) << e.what();
    }
  };
  refused("GIF89a, and then some more bytes", "found no PNG");
  refused(whole.substr(0, 20), "found no PNG");
  std::string other = whole;
  other[24] = 8;
  refused(other, "of 8 bits");
  other = whole;
  other[16] = 0x7f;
  refused(other, "pixels");
  refused(whole.substr(0, 33), "damaged");
}

TEST(DepthPng, ReadsRealDepth) {
  const auto file = sharedData("depth/itop/ITOP_train_000000000053.png");
  if (!exists(file)) GTEST_SKIP() << file;
  const tracking::DepthImage image = tracking::loadDepthPng(file, 1000.0);
  EXPECT_EQ(image.width, 320);
  EXPECT_EQ(image.height, 240);
  const float middle = image.at(160, 120);
  EXPECT_GT(middle, 1.0f);
  EXPECT_LT(middle, 5.0f);
}

}  // namespace depth_png_test
}  // namespace abstand::testing
