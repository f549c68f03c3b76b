// People in hard postures, behind furniture and at the edge of the image, tracked.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/tracking/tracker/posed_scenes.hpp"
#include "tracking/tracker/clip_tracker.hpp"
#include "tracking/tracker/turned_round.hpp"

namespace abstand::tracking {
namespace posed_people_test {

using humanmodel::SkeletonFrame;
using testing::JointErrors;

constexpr double kSamePlace = 0.5;  // m, of the hips: farther away it is not the person
constexpr double kRightWayRound = 0.99, kWithinReach = 0.99, kHiddenWithin = 0.97;  // shares
constexpr double kRawMean = 0.050, kRawP95 = 0.130;                                 // m, tracked joints
constexpr double kWidestInterval = 0.60;                                            // m, of statures
constexpr double kStature = 0.04;                                                   // m

struct Case {
  testing::PosedScene scene;
  double within{kWithinReach}, mean{kRawMean}, p95{kRawP95};
};
void PrintTo(const Case& c, std::ostream* out) { *out << c.scene.name; }

std::vector<Case> cases() {
  std::vector<Case> out;
  for (testing::PosedScene& scene : testing::posedScenes()) {
    Case c{std::move(scene)};
    // Hands and shins that were taken for the legs of the chair had errors of 0.2 m.
    if (c.scene.name == "seated" || c.scene.name == "sitting_down" || c.scene.name == "standing_up")
      c.mean = 0.035, c.p95 = 0.070;
    if (c.scene.name == "still_from_behind_at_5_m") c.mean = 0.065;
    // The mark of standing columns, which is for chairs, made it 38 mm.
    if (c.scene.name == "kneeling") c.mean = 0.030;
    out.push_back(std::move(c));
  }
  return out;
}

/// The person of a track, of whichever number, in each image.
struct Followed {
  std::vector<SkeletonFrame> frames;
  std::size_t numbers{0};  ///< that the person had
  std::size_t ghosts{0};   ///< people that are none
  const ClipPerson* first{nullptr};
};

Followed follow(const ClipTrack& track, const std::vector<SkeletonFrame>& truth) {
  Followed out;
  std::vector<bool> is_person(track.people.size(), false);
  for (const SkeletonFrame& frame : truth) {
    SkeletonFrame none;
    none.t = frame.t;
    out.frames.push_back(none);
    double best = kSamePlace;
    std::size_t who = track.people.size();
    for (std::size_t k = 0; k < track.people.size(); ++k)
      for (const SkeletonFrame& f : track.people[k].frames) {
        if (std::abs(f.t - frame.t) > 1e-6 || !f.has(humanmodel::Joint::kPelvis)) continue;
        const double off = (f[humanmodel::Joint::kPelvis] - frame[humanmodel::Joint::kPelvis]).norm();
        if (off >= best) continue;
        best = off;
        who = k;
        out.frames.back() = f;
      }
    if (who < track.people.size()) is_person[who] = true;
  }
  for (std::size_t k = 0; k < is_person.size(); ++k) {
    (is_person[k] ? out.numbers : out.ghosts) += 1;
    if (is_person[k] && !out.first) out.first = &track.people[k];
  }
  return out;
}

/// Share of the images with the hips the right way round.
double shareRightWayRound(const std::vector<SkeletonFrame>& frames, const std::vector<SkeletonFrame>& truth) {
  using enum humanmodel::Joint;
  double right = 0.0, all = 0.0;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (!frames[i].has(kHipLeft)) continue;
    all += 1.0;
    right += (frames[i][kHipLeft] - frames[i][kHipRight]).dot(truth[i][kHipLeft] - truth[i][kHipRight]) > 0.0;
  }
  return right / all;
}

class PosedPeople : public ::testing::TestWithParam<Case> {};

TEST_P(PosedPeople, AreTrackedWithinTolerance) {
  const Case& c = GetParam();
  auto clip = testing::simulate(c.scene);
  const ClipTrack track = trackClip(*clip.stream, {});
  const Followed person = follow(track, clip.truth);
  JointErrors errors = testing::compare(person.frames, clip.truth);
  std::vector<double> seen = errors.tracked.error;
  std::sort(seen.begin(), seen.end());
  ASSERT_FALSE(seen.empty());
  ASSERT_TRUE(person.first);
  const Facing facing = person.first->facing;
  const Stature stature = person.first->stature;
  std::printf(
      "| %s | %.2f, %.2f%s | %.2f [%.2f, %.2f] | %zu of %zu | %zu | %zu | %.0f / %.0f | %.3f, x %.1f (%zu) | "
      "%.3f, x %.1f (%zu) |\n",
      c.scene.name.c_str(), shareRightWayRound(person.frames, clip.truth), facing.ratio,
      facing.decided() ? "" : " undecided", stature.used, stature.interval[0], stature.interval[1],
      errors.lost, clip.truth.size(), person.numbers, person.ghosts, 1e3 * JointErrors::mean(seen),
      1e3 * JointErrors::quantile(seen, 0.95), errors.tracked.within(), errors.tracked.medianRatio(),
      errors.tracked.error.size(), errors.inferred.within(), errors.inferred.medianRatio(),
      errors.inferred.error.size());
  EXPECT_GE(shareRightWayRound(person.frames, clip.truth), kRightWayRound);
  EXPECT_EQ(person.first->found, clip.truth.size());
  EXPECT_EQ(person.numbers, 1u);
  EXPECT_EQ(person.ghosts, 0u);
  if (stature.known()) {
    EXPECT_NEAR(stature.used, testing::kPosedStature, kStature);
  } else {
    EXPECT_LE(stature.interval[0], testing::kPosedStature);
    EXPECT_GE(stature.interval[1], testing::kPosedStature);
    EXPECT_LE(stature.interval[1] - stature.interval[0], kWidestInterval);
  }
  EXPECT_THAT(person.first->held, ::testing::Each(0u)) << "things in empty hands";
  EXPECT_LE(JointErrors::mean(seen), c.mean);
  EXPECT_LE(JointErrors::quantile(seen, 0.95), c.p95);
  EXPECT_GE(errors.tracked.within(), c.within);
  EXPECT_GE(errors.inferred.within(), kHiddenWithin);
  if (facing.decided()) return;
  // Who faces the other way would look the same.
  std::vector<SkeletonFrame> other;
  for (const SkeletonFrame& frame : clip.truth) other.push_back(flippedFacing(frame));
  EXPECT_GE(testing::compare(person.frames, other).tracked.within(), kWithinReach) << "the other way round";
}

// A person squats with the head between the knees and rises again. The back of the model is straight, so that
// hips and knees are up to 0.2 m off meanwhile; the pose uncertainty states it. Measured: 0.990; before this
// term and the straight leg 0.916.
TEST(CurledUp, ReachCoversFoldedHipsAndRisingPersonHasBothLegs) {
  constexpr double kWithin = 0.98;
  // s; m, mean error of knees from then on. Measured: 0.033; 0.28 without the straight leg as a candidate: a
  // leg stayed folded.
  constexpr double kUpright = 4.0, kKnees = 0.06;
  using enum humanmodel::Joint;
  for (const testing::PosedScene& scene : testing::heldOutScenes()) {
    if (scene.name != "other_curled_up_small") continue;
    auto clip = testing::simulate(scene);
    const ClipTrack track = trackClip(*clip.stream, {});
    ASSERT_EQ(track.people.size(), 1u);
    const std::vector<SkeletonFrame>& frames = track.people[0].frames;
    const JointErrors errors = testing::compare(frames, clip.truth);
    EXPECT_GE(errors.tracked.within(), kWithin);
    double sum = 0.0, count = 0.0;
    for (const SkeletonFrame& frame : frames) {
      if (frame.t < kUpright) continue;
      const auto truth = std::find_if(clip.truth.begin(), clip.truth.end(),
                                      [&](const SkeletonFrame& f) { return std::abs(f.t - frame.t) < 1e-6; });
      ASSERT_NE(truth, clip.truth.end());
      for (const humanmodel::Joint knee : {kKneeLeft, kKneeRight}) {
        ASSERT_TRUE(frame.has(knee));
        sum += (frame[knee] - (*truth)[knee]).norm();
        count += 1.0;
      }
    }
    ASSERT_GT(count, 0.0);
    EXPECT_LE(sum / count, kKnees);
    return;
  }
  FAIL() << "no such scene";
}

// The interval of an unknown stature is narrow, and holds those of short and tall people too.
TEST(UnknownStature, IntervalHoldsShortAndTallPeople) {
  for (const testing::PosedScene& scene : testing::posedScenes()) {
    if (scene.name != "kneeling" && scene.name != "behind_a_bench" && scene.name != "lying_from_the_side")
      continue;
    for (const double stature : {1.58, 1.92}) {
      std::vector<SkeletonFrame> truth = testing::posedFrames(scene.postures);
      for (SkeletonFrame& frame : truth)
        for (Vector3d& p : frame.p) p *= stature / testing::kPosedStature;
      const auto clip = testing::simulate(
          {.recording = {}, .eye = scene.eye, .look = scene.look, .room = true}, truth, scene.furniture);
      const ClipTrack track = trackClip(*clip.stream, {});
      ASSERT_EQ(track.people.size(), 1u);
      const Stature& found = track.people[0].stature;
      std::printf("%s, %.2f m: %.2f [%.2f, %.2f]\n", scene.name.c_str(), stature, found.used,
                  found.interval[0], found.interval[1]);
      EXPECT_FALSE(found.known());
      EXPECT_LE(found.interval[0], stature);
      EXPECT_GE(found.interval[1], stature);
      EXPECT_LE(found.interval[1] - found.interval[0], kWidestInterval);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Postures, PosedPeople, ::testing::ValuesIn(cases()),
                         [](const auto& one) { return one.param.scene.name; });

}  // namespace posed_people_test
}  // namespace abstand::tracking
