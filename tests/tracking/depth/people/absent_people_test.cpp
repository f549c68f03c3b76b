// Who appears where somebody disappeared: the same person, or another one.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "tests/tracking/tracker/small_camera.hpp"
#include "tracking/depth/people/people_finder.hpp"

namespace abstand::tracking {
namespace absent_people_test {

constexpr double kEye = 1.3, kAway = 3.0;      // m, of a level camera; of the person
constexpr double kStep = 0.1;                  // s between images
constexpr double kSide = -1.2, kMiddle = 0.0;  // m, to the right; the image ends at 1.65 m
constexpr double kTall = 1.85, kShort = 1.55;  // m

DepthCamera levelCamera() { return smallCameraAt({0.0, 0.0, kEye}, {1.0, 0.0, kEye}); }

/// Legs, trunk and head of a person of `stature`; 0: nobody.
DepthImage imageOf(double right, double stature) {
  const DepthCamera camera = levelCamera();
  DepthImage image(camera.width, camera.height);
  for (int v = 0; v < image.height; ++v)
    for (int u = 0; u < image.width; ++u) {
      const Vector3d p = camera.at(u, v, kAway);
      const double up = (kEye - p.y()) / stature, aside = std::abs(p.x() - right);
      const bool is_leg = up > 0.06 && up < 0.47 && aside > 0.03 && aside < 0.17;
      const bool is_trunk = up >= 0.47 && up < 0.82 && aside < 0.22;
      const bool is_head = up >= 0.82 && up < 1.0 && aside < 0.09;
      if (stature > 0.0 && (is_leg || is_trunk || is_head))
        image.z[static_cast<std::size_t>(v * image.width + u)] =
            static_cast<float>(is_leg ? kAway + 0.06 : kAway);
    }
  return image;
}

/// Numbers of who stands at `right` for 2 s, is not there for `absent` (s), and is `then` (m) high for 2 s.
std::set<int> numbersOf(double right, double absent, double then) {
  PeopleFinder finder(levelCamera(), {});
  std::set<int> numbers;
  for (double t = 0.0; t < 4.0 + absent; t += kStep) {
    const double stature = t < 2.0 ? kTall : t < 2.0 + absent ? 0.0 : then;
    for (const FoundPerson& person : finder.find(t, imageOf(right, stature)).persons)
      numbers.insert(person.id);
  }
  return numbers;
}

TEST(AbsentPeople, KeepTheirNumberIfTheyAreAsHigh) {
  EXPECT_EQ(numbersOf(kSide, 1.5, kTall).size(), 1u);
  EXPECT_EQ(numbersOf(kMiddle, 1.5, kTall).size(), 1u);
}

// Before, somebody else had the number, the body and the facing direction of who had left.
TEST(AbsentPeople, AreOthersAtTheSideOfTheImageIfTheyAreNot) {
  EXPECT_EQ(numbersOf(kSide, 1.5, kShort).size(), 2u);
}

TEST(AbsentPeople, MayBendBehindThingsInTheMiddleOfTheImage) {
  EXPECT_EQ(numbersOf(kMiddle, 1.5, kShort).size(), 1u);
}

TEST(AbsentPeople, AreForgottenAfterAWhile) {
  EXPECT_EQ(numbersOf(kSide, PeopleFinderOptions{}.keep + 0.5, kTall).size(), 2u);
}

}  // namespace absent_people_test
}  // namespace abstand::tracking
