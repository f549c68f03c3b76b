// Images of brightness, and files that are none.
#include "tracking/depth/formats/grey_png.hpp"

#include <gtest/gtest.h>

#include "core/base/error.hpp"
#include "core/base/text_file.hpp"
#include "tests/support/paths.hpp"
#include "tracking/depth/camera/depth_image.hpp"
#include "tracking/depth/formats/colour_png.hpp"
#include "tracking/depth/formats/depth_png.hpp"

namespace abstand::testing {
namespace grey_png_test {

TEST(GreyPng, ReadsColourAndSixteenBits) {
  ScratchFolder folder;
  tracking::ColourImage colour(3, 2);
  colour.at(1, 0) = {200, 200, 200};
  colour.at(2, 1) = {255, 0, 0};
  tracking::saveColourPng(colour, folder.path() / "colour.png");
  const tracking::GreyImage grey = tracking::loadGreyPng(folder.path() / "colour.png");
  EXPECT_EQ(grey.width, 3);
  EXPECT_EQ(grey.height, 2);
  EXPECT_EQ(grey.at(1, 0), 200);
  EXPECT_NEAR(grey.at(2, 1), 76, 1);  // 0.299 of red
  // An infrared camera's 10 bits in 16.
  tracking::DepthImage infrared(2, 1);
  infrared.at(0, 0) = 0.25f;
  infrared.at(1, 0) = 1.0f;
  tracking::saveDepthPng(infrared, 1000.0, folder.path() / "infrared.png");
  EXPECT_EQ(tracking::loadGreyPng(folder.path() / "infrared.png").at(1, 0), 255);
  EXPECT_NEAR(tracking::loadGreyPng(folder.path() / "infrared.png").at(0, 0), 64, 1);
}

TEST(GreyPng, RejectsBadFiles) {
  ScratchFolder folder;
  EXPECT_THROW(tracking::loadGreyPng(folder.path() / "none.png"), ParseError);
  EXPECT_THROW(tracking::loadGreyPng(folder.write("text.png", "no image")), ParseError);
  tracking::saveColourPng(tracking::ColourImage(30, 20), folder.path() / "whole.png");
  const std::string bytes = readFile(folder.path() / "whole.png");
  for (const std::size_t n : {std::size_t{20}, std::size_t{30}, bytes.size() / 2})
    EXPECT_THROW(tracking::loadGreyPng(folder.write("cut.png", bytes.substr(0, n))), ParseError) << n;
  std::string huge = bytes;
  huge[16] = '\x7f';
  EXPECT_THROW(tracking::loadGreyPng(folder.write("huge.png", huge)), ParseError);
}

}  // namespace grey_png_test
}  // namespace abstand::testing
