// A camera that is pushed while it records is noticed, and what it saw afterwards is not used.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/tracking/tracker/posed_person.hpp"
#include "tests/tracking/tracker/simulated_clip.hpp"
#include "tracking/tracker/clip_tracker.hpp"
#include "tracking/tracker/tracked_recording.hpp"

namespace abstand::tracking {
namespace camera_moved_test {

constexpr double kPushed = 0.8, kFrame = 1.0 / 30.0;  // s

/// A person in a room; the camera looks down by `push` and to the right by `aside` (rad) more from kPushed
/// on.
ClipTrack trackedWith(double push, double aside = 0.0) {
  const std::vector<testing::Posture> postures{{.t = 0.0}, {.t = 1.5, .reach = 0.4}};
  auto clip = testing::simulate({.recording = {},
                                 .room = true,
                                 .width = 160,
                                 .push_at = kPushed - 1e-6,
                                 .push = push,
                                 .push_aside = aside},
                                testing::posedFrames(postures), {});
  return trackClip(*clip.stream, {});
}

TEST(CameraMoved, IsSaidAndNobodyIsFoundFromThenOn) {
  const ClipTrack track = trackedWith(unit::deg(4.0));
  EXPECT_NEAR(track.cameras.at(0).moved_at, kPushed, 1.5 * kFrame);
  EXPECT_EQ(track.cameras[0].repeated, 0u);
  EXPECT_THAT(cameraWarnings(track),
              ::testing::ElementsAre(::testing::HasSubstr("the camera was moved at 0.8")));
  ASSERT_FALSE(track.people.empty());
  std::size_t before = 0;
  for (const ClipPerson& person : track.people)
    for (const humanmodel::SkeletonFrame& frame : person.frames) {
      const bool has_body = frame.has(humanmodel::Joint::kPelvis);
      before += has_body;
      EXPECT_FALSE(has_body && frame.t >= track.cameras[0].moved_at) << frame.t;
    }
  EXPECT_EQ(before, track.people[0].found);
  EXPECT_GT(before, 15u);
}

// In front of a wall: the middle of the image hardly changes.
TEST(CameraMoved, IsSaidOfOneThatIsTurnedAside) {
  for (const double degrees : {-3.0, 2.0, 6.0, 12.0}) {
    const ClipTrack track = trackedWith(0.0, unit::deg(degrees));
    EXPECT_NEAR(track.cameras.at(0).moved_at, kPushed, 2.5 * kFrame) << degrees;
  }
}

TEST(CameraMoved, IsNotSaidOfOneThatStands) {
  const ClipTrack track = trackedWith(0.0);
  EXPECT_EQ(track.cameras.at(0).moved_at, kInfinity);
  EXPECT_TRUE(cameraWarnings(track).empty());
  EXPECT_GT(track.people.at(0).found, 40u);
}

}  // namespace camera_moved_test
}  // namespace abstand::tracking
