// Postures, furniture, cameras.
#include "tests/tracking/tracker/posed_scenes.hpp"

#include <cmath>

#include "tests/tracking/tracker/postures.hpp"

namespace abstand::testing {
namespace {

/// On the feet of seated().
Posture standingUp(double t) {
  return {.t = t, .hips = {0.42, 0.0, 0.922}, .reach = 0.46, .foot = 0.44, .apart = 0.12};
}

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

/// On the back, the head away from +x; `x` (m) of the hips.
Posture lying(double t, double x) {
  return {.t = t,
          .hips = {x, 0.0, 0.12},
          .loins = -0.5 * kPi,
          .back = -0.5 * kPi,
          .head = -0.5 * kPi,
          .reach = x + 0.06,
          .aside = 0.30,
          .low = 0.09,
          .foot = x + 0.84,
          .apart = 0.12,
          .ankle = 0.09,
          .toes = 1.2};
}
Posture seatedOnTheFloor(double t) {
  return {.t = t,
          .hips = {-0.25, 0.0, 0.12},
          .loins = -0.2,
          .reach = -0.35,
          .aside = 0.35,
          .low = 0.15,
          .foot = 0.40,
          .apart = 0.14};
}

/// On the front, the head towards +x.
Posture prone(double t) {
  return {.t = t,
          .hips = {-0.2, 0.0, 0.12},
          .loins = 0.5 * kPi,
          .back = 0.5 * kPi,
          .head = 0.5 * kPi,
          .reach = 0.40,
          .aside = 0.38,
          .low = 0.06,
          .foot = -1.04,
          .apart = 0.12,
          .ankle = 0.09,
          .toes = -2.8};
}
/// On the front with straight legs, the head towards +x: the arms along the body, or bent beside the head.
Posture proneArmsDown(double t) {
  Posture p = prone(t);
  p.reach = -0.24;
  p.aside = 0.30;
  p.low = 0.08;
  p.foot = -1.06;
  p.toes = -2.6;
  return p;
}
Posture proneArmsUp(double t) {
  Posture p = proneArmsDown(t);
  p.reach = 0.62;
  p.aside = 0.42;
  return p;
}
/// On the feet, the head between the knees.
Posture curledUp(double t) {
  return {.t = t,
          .hips = {-0.15, 0.0, 0.30},
          .loins = 1.0,
          .back = 1.9,
          .head = 2.5,
          .reach = 0.20,
          .aside = 0.25,
          .low = 0.15,
          .foot = 0.05,
          .apart = 0.14};
}

const std::vector<FurnitureBox> kChair{{{-0.22, -0.22, 0.37}, {0.22, 0.22, 0.41}},
                                       {{-0.26, -0.22, 0.0}, {-0.22, 0.22, 0.95}},
                                       {{0.18, -0.22, 0.0}, {0.22, -0.18, 0.37}},
                                       {{0.18, 0.18, 0.0}, {0.22, 0.22, 0.37}}};
const std::vector<FurnitureBox> kBench{{{0.45, -0.8, 0.0}, {0.95, 0.8, 0.9}}};

// Of people seen from all sides.
const std::vector<Posture> kWork{standing(0.0), handsAhead(1.2), standing(2.5)};
const std::vector<Posture> kSit{seated(0.0), seated(2.5)}, kKneel{kneeling(0.0), kneeling(2.5)};
const std::vector<Posture> kBend{standing(0.0), standing(0.6), bent(1.5), bent(2.0), standing(3.0)};

}  // namespace

std::vector<PosedScene> posedScenes() {
  const std::vector<Posture> stand{standing(0.0), handsAhead(1.5), standing(3.0)};
  const std::vector<Posture> sit{seated(0.0), seated(3.0)}, kneel{kneeling(0.0), kneeling(3.0)};
  const std::vector<Posture> bend{standing(0.0), standing(0.8), bent(1.8),
                                  bent(2.4),     standing(3.4), standing(4.0)};
  const std::vector<Posture> sit_down{standing(0.0), standing(0.8), seated(2.0), seated(2.8), standing(4.0)};
  const std::vector<Posture> kneel_down{standing(0.0), standing(0.8), kneeling(2.0), kneeling(2.8),
                                        standing(4.0)};
  const std::vector<Posture> lie{lying(0.0, 0.0), lying(3.0, 0.0)};
  const Vector3d high{2.8, 0.0, 2.6};
  return {
      {"at_2_m", stand, {2.0, 0.0, 1.2}},
      {"at_4_m", stand, {4.0, 0.0, 1.2}},
      {"at_5_m", stand, {5.0, 0.0, 1.2}},
      {"from_behind_at_2_8_m", stand, {-2.8, 0.0, 1.2}},
      {"from_behind_at_4_m", stand, {-4.0, 0.0, 1.2}},
      {"camera_at_2_6_m", stand, high},
      {"seated", sit, {2.8, 0.0, 1.2}, {0.0, 0.0, 0.9}, kChair},
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
       kChair},
      {"kneeling_down", kneel_down},
      {"near_1_2_m", stand, {1.2, 0.0, 1.2}, {0.0, 0.0, 1.2}},
      {"near_camera_at_2_6_m", stand, {1.2, 0.0, 2.6}, {0.0, 0.0, 1.2}},
      {"still_at_4_m", {standing(0.0), standing(3.0)}, {4.0, 0.0, 1.2}, {0.0, 0.0, 0.9}, {}, 3},
      {"still_at_5_m", {standing(0.0), standing(3.0)}, {5.0, 0.0, 1.2}, {0.0, 0.0, 0.9}, {}, 5},
      {"still_from_behind_at_4_m", {standing(0.0), standing(3.0)}, {-4.0, 0.0, 1.2}, {0.0, 0.0, 0.9}, {}, 3},
      {"still_from_behind_at_5_m", {standing(0.0), standing(3.0)}, {-5.0, 0.0, 1.2}, {0.0, 0.0, 0.9}, {}, 5},
      {"still_camera_at_2_6_m", {standing(0.0), standing(3.0)}, high, {0.0, 0.0, 0.9}, {}, 3},
      {"still_behind_a_bench", {standing(0.0), standing(3.0)}, {2.8, 0.0, 1.2}, {0.0, 0.0, 0.9}, kBench, 3},
      {"stooping", {standing(0.0), standing(0.8), stooped(1.8), stooped(2.4), standing(3.4), standing(4.0)}},
      {"stooping_from_the_side",
       {standing(0.0), standing(0.8), stooped(1.8), stooped(2.4), standing(3.4), standing(4.0)},
       {0.5, -2.6, 1.2}},
      {"lying", lie},
      {"lying_from_the_side", lie, {0.5, -2.6, 1.2}},
      {"lying_camera_at_2_6_m", lie, {0.5, -2.6, 2.6}},
      {"lying_down",
       {standing(0.0), standing(0.6), squatting(1.6), seatedOnTheFloor(2.4), lying(3.4, -0.25),
        lying(4.5, -0.25)},
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

std::vector<PosedScene> heldOutScenes() {
  constexpr double kSmall = 1.58, kTall = 1.92;
  const std::vector<Posture> stand{standing(0.0), handsAhead(1.2), armsAside(2.2), standing(3.2)};
  const std::vector<Posture> sit{seated(0.0), seated(3.0)}, kneel{kneeling(0.0), kneeling(3.0)};
  const std::vector<Posture> bend{standing(0.0), standing(0.8), bent(1.6), bent(2.2), standing(3.0)};
  const std::vector<Posture> curl{standing(0.0), standing(0.8), curledUp(2.0), curledUp(3.0), standing(4.2)};
  const Vector3d aside{2.5, 0.9, 1.5}, above{2.2, -0.8, 2.4}, look{0.0, 0.0, 0.9};
  std::vector<PosedScene> scenes{{"other_seated", sit, aside, look, kChair, 7},
                                 {"other_seated_seen_from_above", sit, above, look, kChair, 8},
                                 {"other_kneeling", kneel, aside, look, {}, 9},
                                 {"other_behind_a_bench", stand, {2.6, 0.4, 1.5}, look, kBench, 10},
                                 {"other_near_1_3_m", stand, {1.3, 0.2, 1.4}, {0.0, 0.0, 1.2}, {}, 11},
                                 {"other_bending", bend, aside, look, {}, 12},
                                 {"other_at_3_m", stand, {2.9, -0.8, 1.7}, look, {}, 13},
                                 {"other_curled_up", curl, above, look, {}, 14}};
  std::vector<PosedScene> both;
  for (const double stature : {kSmall, kTall})
    for (PosedScene scene : scenes) {
      scene.name += stature == kSmall ? "_small" : "_tall";
      scene.stature = stature;
      both.push_back(scene);
    }
  const std::vector<Posture> down{proneArmsDown(0.0), proneArmsDown(3.0)};
  const std::vector<Posture> up{proneArmsUp(0.0), proneArmsUp(3.0)};
  for (const double stature : {kSmall, kTall}) {
    const std::string of = stature == kSmall ? "_small" : "_tall";
    both.push_back({"other_prone_arms_down" + of, down, {0.2, 2.4, 1.8}, look, {}, 16, {}, stature});
    both.push_back({"other_prone_arms_up" + of, up, {-0.6, -2.5, 1.5}, look, {}, 17, {}, stature});
    both.push_back({"other_prone_feet_ahead" + of, down, {-3.0, 0.5, 1.7}, look, {}, 18, {}, stature});
    both.push_back({"other_prone_seen_from_above" + of, up, {1.6, 1.2, 2.6}, look, {}, 19, {}, stature});
  }
  both.push_back({"other_lying_on_the_front", {prone(0.0), prone(3.0)}, {0.5, -2.6, 1.4}, look, {}, 15});
  return both;
}

std::vector<PosedScene> raisedScenes() {
  const struct {
    const char* name;
    double reach, aside, low;
  } hands[] = {{"straight_up", 0.05, 0.16, 2.0},
               {"up_and_apart", 0.05, 0.30, 1.95},
               {"ahead_and_up", 0.25, 0.18, 1.85},
               {"on_the_head", 0.05, 0.10, 1.72},
               {"behind_the_head", -0.10, 0.12, 1.65}};
  std::vector<PosedScene> scenes;
  for (const auto& [name, reach, aside, low] : hands)
    for (const auto& [suffix, eye] : eightSides()) {
      const auto raised = [reach = reach, aside = aside, low = low](double t) {
        return Posture{.t = t, .reach = reach, .aside = aside, .low = low, .elbows = {0.4, 1.0, 0.0}};
      };
      const Vector3d look(0.0, 0.0, 1.1);
      const std::string of = name + suffix;
      scenes.push_back({"hands_" + of, {raised(0.0), raised(1.5), standing(2.0), standing(2.5)}, eye, look});
      scenes.push_back(
          {"raising_" + of, {standing(0.0), standing(0.8), raised(1.3), raised(2.5)}, eye, look});
    }
  return scenes;
}

std::vector<PosedScene> posturesFromAllSides() {
  const std::vector<Posture> squat{standing(0.0), standing(0.6), squatting(1.5), squatting(2.0),
                                   standing(3.0)};
  const std::vector<Posture> sit_down{standingUp(0.0), standingUp(0.6), seated(1.6), seated(2.5)};
  const std::vector<Posture> stand_up{seated(0.0), seated(0.8), standingUp(1.8), standingUp(2.8)};
  const std::vector<Posture> kneel_down{standing(0.0), standing(0.6), kneeling(1.6), kneeling(2.5)};
  const struct {
    const char* name;
    const std::vector<Posture>& postures;
    std::vector<FurnitureBox> furniture;
  } kinds[] = {{"seated", kSit, kChair},          {"kneeling", kKneel, {}},
               {"bench", kWork, kBench},          {"bending", kBend, {}},
               {"squatting", squat, {}},          {"sitting_down", sit_down, kChair},
               {"standing_up", stand_up, kChair}, {"kneeling_down", kneel_down, {}}};
  std::vector<PosedScene> scenes;
  for (const auto& [name, postures, furniture] : kinds)
    for (const auto& [suffix, eye] : eightSides())
      scenes.push_back({name + suffix, postures, eye, {0.0, 0.0, 0.9}, furniture});
  return scenes;
}

std::vector<PosedScene> posturesFromOtherPlaces() {
  const struct {
    const char* name;
    const std::vector<Posture>& postures;
    double look;  // m, height
    std::vector<FurnitureBox> furniture;
  } kinds[] = {{"standing", kWork, 0.9, {}},
               {"seated", kSit, 0.6, kChair},
               {"kneeling", kKneel, 0.6, {}},
               {"bending", kBend, 0.9, {}}};
  const struct {
    const char* name;
    double distance, height;  // m
  } places[] = {{"low", 2.5, 0.5}, {"above", 1.5, 2.8}, {"high", 4.0, 2.8}, {"far", 5.0, 1.2}};
  std::vector<PosedScene> scenes;
  for (const auto& [kind, postures, look, furniture] : kinds)
    for (const auto& [place, distance, height] : places)
      for (const auto& [suffix, eye] : eightSides(distance, height))
        scenes.push_back(
            {std::string(kind) + "_" + place + suffix, postures, eye, {0.0, 0.0, look}, furniture});
  return scenes;
}

std::vector<PosedScene> heldScenes() {
  using enum HeldBox::Grip;
  const std::vector<Posture> stand{standing(0.0), handsAhead(1.5), standing(3.0)};
  const std::vector<Posture> swing{
      standing(0.0), {.t = 1.5, .reach = 0.10, .aside = 0.50, .low = 1.0}, standing(3.0)};
  const std::vector<Posture> carry{{.t = 0.0, .reach = 0.38, .aside = 0.18, .low = 0.95},
                                   {.t = 1.5, .reach = 0.40, .aside = 0.18, .low = 1.25},
                                   {.t = 3.0, .reach = 0.38, .aside = 0.18, .low = 0.95}};
  const Vector3d front{2.8, 0.0, 1.2}, look{0.0, 0.0, 0.9}, side{0.5, -2.6, 1.2};
  // Across the palm, from 0.15 m below the fist to 0.35 m above it.
  const std::vector<HeldBox> bar{{kRight, {-0.09, -0.02, -0.15}, {-0.05, 0.02, 0.35}}};
  // As a case that hangs from the hand.
  const std::vector<HeldBox> suitcase{{kRight, {-0.02, -0.08, -0.20}, {0.28, 0.08, 0.20}}};
  const std::vector<HeldBox> carton{{kBoth, {-0.25, -0.15, -0.12}, {0.05, 0.15, 0.12}}};
  return {{"bar", stand, front, look, {}, 0, bar},
          {"bar_from_the_side", stand, side, look, {}, 0, bar},
          {"suitcase", swing, front, look, {}, 0, suitcase},
          {"suitcase_from_the_side", swing, side, look, {}, 0, suitcase},
          {"carton", carry, front, look, {}, 0, carton},
          {"carton_camera_at_2_6_m", carry, {2.8, 0.0, 2.6}, look, {}, 0, carton}};
}

std::vector<PosedScene> seatedHeldScenes() {
  using enum HeldBox::Grip;
  const auto carrying = [](double t, double low) {
    Posture p = seated(t);
    p.reach = 0.36;
    p.aside = 0.17;
    p.low = low;
    return p;
  };
  const std::vector<Posture> sit{seated(0.0), seated(3.0)};
  const std::vector<Posture> lap{carrying(0.0, 0.66), carrying(1.5, 0.72), carrying(3.0, 0.66)};
  const Vector3d front{2.8, 0.0, 1.2}, high{2.8, 0.0, 2.6}, look{0.0, 0.0, 0.9};
  const std::vector<HeldBox> bar{{kRight, {-0.09, -0.02, -0.15}, {-0.05, 0.02, 0.35}}};
  const std::vector<HeldBox> carton{{kBoth, {-0.25, -0.15, -0.12}, {0.05, 0.15, 0.12}}};
  return {{"seated_with_bar", sit, front, look, kChair, 0, bar},
          {"seated_with_bar_camera_at_2_6_m", sit, high, look, kChair, 0, bar},
          {"seated_with_carton", lap, front, look, kChair, 0, carton},
          {"seated_with_carton_camera_at_2_6_m", lap, high, look, kChair, 0, carton}};
}

std::vector<PosedScene> heldOutHeldScenes() {
  using enum HeldBox::Grip;
  constexpr double kSmall = 1.58, kTall = 1.92;
  const std::vector<Posture> lift{standing(0.0),
                                  {.t = 1.2, .reach = 0.30, .aside = 0.35, .low = 1.3},
                                  {.t = 2.2, .reach = 0.45, .aside = 0.30, .low = 1.0},
                                  standing(3.0)};
  const std::vector<Posture> serve{{.t = 0.0, .reach = 0.35, .aside = 0.20, .low = 1.05},
                                   {.t = 1.5, .reach = 0.45, .aside = 0.20, .low = 1.0},
                                   {.t = 3.0, .reach = 0.35, .aside = 0.20, .low = 1.05}};
  const Vector3d aside{2.5, 0.9, 1.5}, front{2.7, -0.5, 1.3}, look{0.0, 0.0, 0.9};
  // A stick across the palm, 0.2 m below and 0.7 m above the fist; a tray; a bucket.
  const std::vector<HeldBox> stick{{kLeft, {-0.08, -0.015, -0.20}, {-0.05, 0.015, 0.70}}};
  const std::vector<HeldBox> tray{{kBoth, {-0.05, -0.22, -0.02}, {0.28, 0.22, 0.03}}};
  const std::vector<HeldBox> bucket{{kLeft, {0.02, -0.13, -0.13}, {0.30, 0.13, 0.13}}};
  std::vector<PosedScene> scenes;
  for (const double stature : {kSmall, kTall}) {
    const std::string of = stature == kSmall ? "_small" : "_tall";
    scenes.push_back({"stick" + of, lift, aside, look, {}, 21, stick, stature});
    scenes.push_back({"tray" + of, serve, front, look, {}, 22, tray, stature});
    scenes.push_back({"bucket" + of, lift, front, look, {}, 23, bucket, stature});
  }
  return scenes;
}

SimulatedClip simulate(const PosedScene& scene) {
  const double scale = scene.stature / kPosedStature;
  std::vector<humanmodel::SkeletonFrame> frames = posedFrames(scene.postures);
  for (humanmodel::SkeletonFrame& frame : frames)
    for (Vector3d& p : frame.p) p *= scale;
  std::vector<FurnitureBox> furniture = scene.furniture;
  for (FurnitureBox& box : furniture) {
    box.low *= scale;
    box.high *= scale;
    box.swing *= scale;
  }
  return simulate({.recording = {},
                   .eye = scene.eye,
                   .look = scene.look,
                   .body_seed = scene.body_seed,
                   .room = true,
                   .held = scene.held},
                  std::move(frames), std::move(furniture));
}

}  // namespace abstand::testing
