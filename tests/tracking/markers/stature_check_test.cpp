// A wrong stature in a file of markers is named, a right one is not.
#include "tracking/markers/stature_check.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>

#include "core/base/text_file.hpp"
#include "tests/support/paths.hpp"
#include "tests/tracking/markers/synthetic_markers.hpp"
#include "tracking/registry/open_recording.hpp"

namespace abstand::tracking {
namespace stature_check_test {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// The C3D file with another value of a floating-point parameter of one number, Intel.
std::string withNumber(std::string c3d, const std::string& name, float value) {
  const auto at = c3d.find(name);
  EXPECT_NE(at, std::string::npos);
  // The name, two bytes to the next parameter, the type, the number of dimensions and each of them.
  const std::size_t type = at + name.size() + 2;
  EXPECT_EQ(c3d[type], 4);
  std::memcpy(&c3d[type + 2 + static_cast<std::size_t>(c3d[type + 1])], &value, sizeof value);
  return c3d;
}

/// The stature of a file is prior knowledge of the fit and checked without it.
TEST(StatureCheck, WrongStatedStatureIsNamed) {
  const testing::ScratchFolder scratch;
  struct Case {
    const char *file, *name;
    std::vector<float> right, wrong;  ///< units of the file
  };
  // Less than 10 % off does not show; the clusters of the second file determine the bones by some 10 % only.
  for (const Case& c : {Case{"PiG/PiG_Motion3_FF.c3d", "Height", {1760, 1700, 1820}, {1500, 1560, 2000}},
                        Case{"sample01/Eb015pi.c3d", "HEIGHT", {1.63f, 1.57f, 1.70f}, {1.40f}}}) {
    const auto file = testing::sharedData(std::string("mocap/c3d/") + c.file);
    if (!std::filesystem::exists(file)) GTEST_SKIP() << file;
    const std::string c3d = readFile(file);
    const auto warnings = [&](float height) {
      return openRecording(scratch.write("h.c3d", withNumber(c3d, c.name, height))).report.warnings;
    };
    for (const float height : c.right)
      EXPECT_THAT(warnings(height), ::testing::Not(::testing::Contains(HasSubstr("states a stature"))))
          << c.file << " " << height;
    for (const float height : c.wrong)
      EXPECT_THAT(warnings(height), ::testing::Contains(HasSubstr("the file states a stature of")))
          << c.file << " " << height;
  }
}

/// On bodies of known size, with markers some centimetres off their places.
TEST(StatureCheck, RightStatedStatureIsNotDoubted) {
  for (const unsigned seed : {1u, 2u}) {
    const auto m = testing::makeMarkers(seed, 1.0, 50.0, 0.001, 0.009);
    const auto doubt = [&](double share) {
      return doubtOfStature({m.base, m.found, m.t, m.moments, share * m.body.height});
    };
    for (const double share : {0.97, 1.0, 1.03}) EXPECT_THAT(doubt(share), IsEmpty()) << seed << " " << share;
    for (const double share : {0.82, 1.2})
      EXPECT_THAT(doubt(share), HasSubstr("which is used, but the markers fit a person of ")) << seed;
  }
}

}  // namespace stature_check_test
}  // namespace abstand::tracking
