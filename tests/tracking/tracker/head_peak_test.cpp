// Heads below raised hands, in rendered images.
#include "tracking/tracker/head_peak.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/no_alloc.hpp"
#include "tests/tracking/tracker/postures.hpp"
#include "tests/tracking/tracker/simulated_clip.hpp"

namespace abstand::tracking {
namespace head_peak_test {

using testing::Posture;

// m: the skin is above the joint, the outline has columns of 3 cm, and a Kinect's noise is 2 cm at 4.5 m.
constexpr double kError = 0.05;

/// What a camera sees of the first image of a person, without a room.
struct Seen {
  testing::SimulatedClip clip;
  BodyObservation observation;

  Seen(const std::vector<Posture>& left, const std::vector<Posture>& right, const Vector3d& eye) {
    std::vector<humanmodel::SkeletonFrame> frames = testing::posedFrames(left);
    const humanmodel::SkeletonFrame other = testing::posedFrames(right).front();
    frames.resize(1);
    using enum humanmodel::Joint;
    for (const humanmodel::Joint j : {kElbowRight, kWristRight, kHandRight}) frames[0].set(j, other[j]);
    clip = testing::simulate({.recording = {}, .eye = eye}, std::move(frames), {});
    DepthFrame frame;
    EXPECT_TRUE(clip.stream->next(frame));
    std::vector<std::uint8_t> is_person;
    for (const float z : frame.image.z) is_person.push_back(z > 0.0f ? 1 : 0);
    const PersonImage image{&frame.image, &clip.stream->camera(), is_person};
    observation.update({&image, 1});
  }
  double vertex() const { return clip.truth.front()[humanmodel::Joint::kHeadTop].z(); }
};

Seen seenFrom(const Posture& left, const Posture& right, const Vector3d& eye) {
  Posture left_end = left, right_end = right;
  left_end.t = right_end.t = 0.1;
  return {{left, left_end}, {right, right_end}, eye};
}

Posture withHand(Posture p, double reach, double aside, double low) {
  p.reach = reach;
  p.aside = aside;
  p.low = low;
  return p;
}

TEST(HeadPeak, IsFoundBelowARaisedHand) {
  for (const Posture& posture : {testing::standing(0.0), testing::kneeling(0.0)}) {
    const Posture raised = withHand(posture, 0.1, 0.45, posture.hips.z() + 1.0);
    int found_far = 0;
    for (const double distance : {2.9, 4.5})
      for (const testing::SideView& view : testing::eightSides(distance, 1.4)) {
        const Seen person = seenFrom(posture, raised, view.eye);
        const std::optional<double> head = headBelowHands(person.observation);
        // From the side, the arm is in front of the head or behind it.
        const bool is_beside = std::abs(view.eye.x()) > 1e-6;
        if (distance < 3.0) {
          EXPECT_EQ(head.has_value(), is_beside) << view.suffix;
        }
        if (head) {
          EXPECT_NEAR(*head, person.vertex(), kError) << view.suffix << " at " << distance;
        }
        found_far += distance > 3.0 && head;
      }
    EXPECT_GE(found_far, 4) << "of 8 from 4.5 m, where images are coarse";
  }
}

TEST(HeadPeak, IsFoundBetweenTwoRaisedHands) {
  const Posture raised = withHand(testing::standing(0.0), 0.1, 0.45, 2.0);
  const Seen person = seenFrom(raised, raised, {2.8, 0.0, 1.2});
  const std::optional<double> head = headBelowHands(person.observation);
  ASSERT_TRUE(head);
  EXPECT_NEAR(*head, person.vertex(), kError);
}

TEST(HeadPeak, IsNotSeenWhereTheHeadIsHighest) {
  for (const Posture& posture : {testing::standing(0.0), testing::seated(0.0), testing::kneeling(0.0),
                                 testing::handsAhead(0.0), testing::armsAside(0.0)})
    for (const testing::SideView& view : testing::eightSides(2.8, 1.4)) {
      const Seen person = seenFrom(posture, posture, view.eye);
      EXPECT_FALSE(headBelowHands(person.observation)) << view.suffix << ", hips at " << posture.hips.z();
    }
}

TEST(HeadPeak, DoesNotAllocateNorNeedPoints) {
  BodyObservation nobody;
  nobody.update({});
  const Seen person = seenFrom(testing::standing(0.0), testing::armsUp(0.0), {2.8, 0.0, 1.2});
  testing::NoAlloc guard;
  EXPECT_FALSE(headBelowHands(nobody));
  headBelowHands(person.observation);
  EXPECT_EQ(guard.count(), 0);
}

}  // namespace head_peak_test
}  // namespace abstand::tracking
