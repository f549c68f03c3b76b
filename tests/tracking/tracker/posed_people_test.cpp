// People in hard postures, behind furniture and at the edge of the image, tracked.
#include <gtest/gtest.h>

#include "tests/tracking/tracker/posed_person.hpp"
#include "tests/tracking/tracker/simulated_clip.hpp"
#include "tracking/tracker/clip_tracker.hpp"
#include "tracking/tracker/turned_round.hpp"

namespace abstand::tracking {
namespace posed_people_test {

using humanmodel::SkeletonFrame;
using testing::FurnitureBox;
using testing::JointErrors;
using testing::Posture;

constexpr double kSamePlace = 0.5;  // m, of the hips: farther away it is not the person
constexpr double kRightWayRound = 0.99, kWithinReach = 0.99, kHiddenWithin = 0.97;  // shares
constexpr double kRawMean = 0.050, kRawP95 = 0.130;                                 // m, tracked joints
constexpr double kStature = 0.04;                                                   // m
constexpr std::size_t kLate = 3;  // images until a head is found that is out of the image

struct Case {
  const char* name;
  std::vector<Posture> postures;
  Vector3d eye{2.8, 0.0, 1.2}, look{0.0, 0.0, 0.9};
  std::vector<FurnitureBox> furniture{};
  std::uint64_t body_seed{0};
  double within{kWithinReach}, mean{kRawMean}, p95{kRawP95};
};
void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

Posture standing(double t) { return {.t = t}; }
Posture seated(double t) {
  return {.t = t,
          .hips = {0.0, 0.0, 0.50},
          .back = 0.1,
          .reach = 0.30,
          .aside = 0.16,
          .low = 0.62,
          .foot = 0.44,
          .apart = 0.12};
}
Posture kneeling(double t) {
  return {.t = t,
          .hips = {0.0, 0.0, 0.48},
          .reach = 0.10,
          .low = 0.46,
          .foot = -0.38,
          .ankle = 0.09,
          .toes = -2.8};
}
Posture bent(double t) {
  return {.t = t,
          .hips = {-0.20, 0.0, 0.70},
          .loins = 1.0,
          .back = 1.7,
          .head = 1.9,
          .reach = 0.35,
          .aside = 0.15,
          .low = 0.20};
}
Posture handsAhead(double t) { return {.t = t, .reach = 0.40, .aside = 0.20, .low = 1.05}; }

Posture stooped(double t) {
  return {.t = t,
          .hips = {-0.25, 0.0, 0.86},
          .loins = 1.4,
          .back = 2.1,
          .head = 2.4,
          .reach = 0.30,
          .aside = 0.15,
          .low = 0.12};
}
Posture armsAside(double t) { return {.t = t, .reach = 0.05, .aside = 0.75, .low = 1.45}; }
Posture armsUp(double t) { return {.t = t, .reach = 0.15, .aside = 0.30, .low = 1.95}; }

const std::vector<FurnitureBox> kChair{{{-0.22, -0.22, 0.37}, {0.22, 0.22, 0.41}},
                                       {{-0.26, -0.22, 0.0}, {-0.22, 0.22, 0.95}},
                                       {{0.18, -0.22, 0.0}, {0.22, -0.18, 0.37}},
                                       {{0.18, 0.18, 0.0}, {0.22, 0.22, 0.37}}};
const std::vector<FurnitureBox> kBench{{{0.45, -0.8, 0.0}, {0.95, 0.8, 0.9}}};

std::vector<Case> cases() {
  const std::vector<Posture> stand{standing(0.0), handsAhead(1.5), standing(3.0)};
  const std::vector<Posture> sit{seated(0.0), seated(3.0)}, kneel{kneeling(0.0), kneeling(3.0)};
  const std::vector<Posture> bend{standing(0.0), standing(0.8), bent(1.8),
                                  bent(2.4),     standing(3.4), standing(4.0)};
  const std::vector<Posture> sit_down{standing(0.0), standing(0.8), seated(2.0), seated(2.8), standing(4.0)};
  const std::vector<Posture> kneel_down{standing(0.0), standing(0.8), kneeling(2.0), kneeling(2.8),
                                        standing(4.0)};
  const Vector3d high{2.8, 0.0, 2.6};
  return {
      {"at_2_m", stand, {2.0, 0.0, 1.2}},
      {"at_4_m", stand, {4.0, 0.0, 1.2}},
      {"at_5_m", stand, {5.0, 0.0, 1.2}},
      {"from_behind_at_2_8_m", stand, {-2.8, 0.0, 1.2}},
      {"from_behind_at_4_m", stand, {-4.0, 0.0, 1.2}},
      {"camera_at_2_6_m", stand, high},
      // A hand on a thigh is taken for a part of it.
      {"seated", sit, {2.8, 0.0, 1.2}, {0.0, 0.0, 0.9}, kChair, 0, kWithinReach, kRawMean, 0.25},
      {"seated_camera_at_2_6_m", sit, high, {0.0, 0.0, 0.9}, kChair},
      {"kneeling", kneel},
      {"kneeling_camera_at_2_6_m", kneel, high},
      {"behind_a_bench", stand, {2.8, 0.0, 1.2}, {0.0, 0.0, 0.9}, kBench},
      {"behind_a_bench_camera_at_2_6_m", stand, high, {0.0, 0.0, 0.9}, kBench},
      {"bending", bend},
      {"bending_camera_at_2_6_m", bend, high},
      {"sitting_down", sit_down, {2.8, 0.0, 1.2}, {0.0, 0.0, 0.9}, kChair},
      {"standing_up",
       {seated(0.0), seated(1.0), standing(2.2), standing(4.5)},
       {2.8, 0.0, 1.2},
       {0.0, 0.0, 0.9},
       kChair,
       0,
       // The legs of a chair are taken for shins.
       0.95,
       0.065,
       0.25},
      {"kneeling_down", kneel_down},
      {"near_1_2_m", stand, {1.2, 0.0, 1.2}, {0.0, 0.0, 1.2}},
      {"near_camera_at_2_6_m", stand, {1.2, 0.0, 2.6}, {0.0, 0.0, 1.2}},
      {"still_at_4_m", {standing(0.0), standing(3.0)}, {4.0, 0.0, 1.2}, {0.0, 0.0, 0.9}, {}, 3},
      {"still_at_5_m", {standing(0.0), standing(3.0)}, {5.0, 0.0, 1.2}, {0.0, 0.0, 0.9}, {}, 5},
      {"still_from_behind_at_4_m", {standing(0.0), standing(3.0)}, {-4.0, 0.0, 1.2}, {0.0, 0.0, 0.9}, {}, 3},
      {"still_from_behind_at_5_m",
       {standing(0.0), standing(3.0)},
       {-5.0, 0.0, 1.2},
       {0.0, 0.0, 0.9},
       {},
       5,
       kWithinReach,
       0.065},
      {"still_camera_at_2_6_m", {standing(0.0), standing(3.0)}, high, {0.0, 0.0, 0.9}, {}, 3},
      {"still_behind_a_bench", {standing(0.0), standing(3.0)}, {2.8, 0.0, 1.2}, {0.0, 0.0, 0.9}, kBench, 3},
      {"stooping", {standing(0.0), standing(0.8), stooped(1.8), stooped(2.4), standing(3.4), standing(4.0)}},
      {"stooping_from_the_side",
       {standing(0.0), standing(0.8), stooped(1.8), stooped(2.4), standing(3.4), standing(4.0)},
       {0.5, -2.6, 1.2}},
      {"near_arms_out_of_the_image",
       {standing(0.0), standing(0.8), armsAside(1.6), armsAside(2.2), standing(3.0)},
       {1.1, 0.0, 1.2},
       {0.0, 0.0, 1.2}},
      {"near_hands_over_the_image",
       {standing(0.0), standing(0.8), armsUp(1.6), armsUp(2.2), standing(3.0)},
       {1.1, 0.0, 1.2},
       {0.0, 0.0, 1.2}},
  };
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
  auto clip = testing::simulate(
      {.recording = {}, .eye = c.eye, .look = c.look, .body_seed = c.body_seed, .room = true},
      testing::posedFrames(c.postures), c.furniture);
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
      c.name, shareRightWayRound(person.frames, clip.truth), facing.ratio,
      facing.decided() ? "" : " undecided", stature.used, stature.interval[0], stature.interval[1],
      errors.lost, clip.truth.size(), person.numbers, person.ghosts, 1e3 * JointErrors::mean(seen),
      1e3 * JointErrors::quantile(seen, 0.95), errors.tracked.within(), errors.tracked.medianRatio(),
      errors.tracked.error.size(), errors.inferred.within(), errors.inferred.medianRatio(),
      errors.inferred.error.size());
  EXPECT_GE(shareRightWayRound(person.frames, clip.truth), kRightWayRound);
  EXPECT_LE(errors.lost, kLate);
  EXPECT_EQ(person.numbers, 1u);
  EXPECT_EQ(person.ghosts, 0u);
  if (stature.known()) {
    EXPECT_NEAR(stature.used, testing::kPosedStature, kStature);
  } else {
    EXPECT_LE(stature.interval[0], testing::kPosedStature);
    EXPECT_GE(stature.interval[1], testing::kPosedStature);
  }
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

INSTANTIATE_TEST_SUITE_P(Postures, PosedPeople, ::testing::ValuesIn(cases()),
                         [](const auto& one) { return one.param.name; });

}  // namespace posed_people_test
}  // namespace abstand::tracking
