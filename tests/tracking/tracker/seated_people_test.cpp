// Short and tall people on a chair, tracked from the front and from above.
#include <gtest/gtest.h>

#include "tests/tracking/tracker/posed_scenes.hpp"
#include "tracking/tracker/clip_tracker.hpp"

namespace abstand::tracking {
namespace seated_people_test {

using testing::JointErrors;

constexpr double kWithin = 0.99, kHiddenWithin = 0.97;  // shares
constexpr double kRawMean = 0.050, kRawP95 = 0.130;     // m, tracked joints; the aim

class SeatedPeople : public ::testing::TestWithParam<testing::PosedScene> {};

// Measured: 30; 54 mm (tall), 44; 87 mm (small), and 29; 55 and 48; 106 mm from above. With the seat as a
// part of the person: 45; 86 and 62; 142 mm, and 64; 169 mm from above, where the tall person, who is as high
// as a short one who stands, was not found.
TEST_P(SeatedPeople, AreFoundAndTrackedInAllImages) {
  auto clip = testing::simulate(GetParam());
  const ClipTrack track = trackClip(*clip.stream, {});
  ASSERT_EQ(track.people.size(), 1u);
  const ClipPerson& person = track.people[0];
  EXPECT_EQ(person.found, clip.truth.size());
  JointErrors errors = testing::compare(person.frames, clip.truth);
  std::vector<double>& seen = errors.tracked.error;
  ASSERT_FALSE(seen.empty());
  EXPECT_GE(errors.tracked.within(), kWithin);
  EXPECT_GE(errors.inferred.within(), kHiddenWithin);
  std::sort(seen.begin(), seen.end());
  EXPECT_LE(JointErrors::mean(seen), kRawMean);
  EXPECT_LE(JointErrors::quantile(seen, 0.95), kRawP95);
  EXPECT_FALSE(person.stature.known());
  EXPECT_LE(person.stature.interval[0], GetParam().stature);
  EXPECT_GE(person.stature.interval[1], GetParam().stature);
}

std::vector<testing::PosedScene> seatedScenes() {
  std::vector<testing::PosedScene> seated = testing::heldOutScenes();
  std::erase_if(seated, [](const testing::PosedScene& scene) {
    return scene.name.find("_seated_") == std::string::npos;
  });
  return seated;
}

INSTANTIATE_TEST_SUITE_P(People, SeatedPeople, ::testing::ValuesIn(seatedScenes()),
                         [](const auto& one) { return one.param.name; });

}  // namespace seated_people_test
}  // namespace abstand::tracking
