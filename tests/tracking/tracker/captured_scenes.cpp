// Files, times, cameras.
#include "tests/tracking/tracker/captured_scenes.hpp"

#include <cmath>

#include "tests/support/paths.hpp"

namespace abstand::testing {

std::vector<CapturedScene> capturedScenes() {
  const auto mocap = [](const char* file) { return sharedData(std::string("mocap/") + file); };
  const auto cmu = [](const char* file) { return debianBvh(file); };
  const auto reach = projectFile("data/scenes/hug_reach.bvh");
  return {
      {"boxing", {.recording = cmu("Boxing_Toes.bvh"), .start = 2.0, .end = 4.5}},
      {"boxing_in_a_room", {.recording = cmu("Boxing_Toes.bvh"), .start = 12.0, .end = 14.0, .room = true}},
      {"reaching", {.recording = reach, .end = 2.0}},
      {"turning_round", {.recording = reach, .end = 4.0, .turn = 0.5 * kPi}},
      {"walking_up",
       {.recording = mocap("bvh/bvhtoolbox_walk01.bvh"),
        .end = 1.6,
        .eye = {4.2, 0.4, 1.2},
        .look = {1.0, 0.0, 0.9}}},
      {"walking_by",
       {.recording = mocap("bvh/bvhtoolbox_walk01.bvh"),
        .end = 2.2,
        .eye = {3.2, -2.2, 1.4},
        .look = {1.5, 0.0, 0.9}}},
      {"waving_in_thick_clothes",
       {.recording = mocap("bvh/fair1_wave_hello.bvh"), .end = 2.0, .clothing = 0.015, .body_seed = 3}},
      {"jumping_jacks", {.recording = mocap("bvh/cmu_jumping_jacks_3dsmax_names.bvh"), .end = 2.5}},
      {"going_down", {.recording = mocap("bvh/mocapbank_test.bvh"), .end = 4.0, .eye = {3.2, 0.0, 1.2}}},
      {"sit_to_stand",
       {.recording = sharedData("kinect/uiprmd_kinect_v2/m05_s01_e01_positions.txt"), .end = 4.0}},
      {"dancing", {.recording = mocap("bvh/rokoko_jesse_dance.bvh"), .end = 3.0, .eye = {3.2, 0.0, 1.2}}},
  };
}

SimulatedClip simulate(const CapturedScene& scene) {
  SimulatedClip clip = simulate(scene.plan);
  if (scene.furniture.empty()) return clip;
  return simulate(scene.plan, std::move(clip.truth), scene.furniture);
}

std::vector<CapturedScene> hardScenes() {
  const auto mocap = [](const char* file) { return sharedData(std::string("mocap/bvh/") + file); };
  const auto boxing = debianBvh("Boxing_Toes.bvh");
  const auto reach = projectFile("data/scenes/hug_reach.bvh");
  return {
      // Fists before the trunk, seen from behind.
      {"boxing_from_behind",
       {.recording = boxing, .start = 2.0, .end = 3.2, .eye = {-2.8, 0.0, 1.2}, .width = 240}},
      // From the side: one arm and one leg hide the other.
      {"boxing_from_the_side",
       {.recording = boxing, .start = 12.0, .end = 13.2, .eye = {1.0, -2.6, 1.2}, .width = 240}},
      {"reaching_turning", {.recording = reach, .end = 1.2, .turn = 0.5 * kPi, .width = 240}},
      // Hands on the hips, a foot behind the other leg.
      {"dancing_short",
       {.recording = mocap("rokoko_jesse_dance.bvh"), .end = 1.2, .eye = {3.2, 0.0, 1.2}, .width = 240}},
      {"jumping_short", {.recording = mocap("cmu_jumping_jacks_3dsmax_names.bvh"), .end = 1.2, .width = 240}},
      {"going_down_from_behind",
       {.recording = mocap("mocapbank_test.bvh"),
        .start = 1.5,
        .end = 2.7,
        .eye = {-3.2, 0.0, 1.2},
        .width = 240}},
  };
}

std::vector<CapturedScene> scenesFromAllSides() {
  constexpr double kLong = 2.0;  // s
  const auto mocap = [](const char* file) { return sharedData(std::string("mocap/bvh/") + file); };
  const struct {
    const char* name;
    std::filesystem::path recording;
    double start;  // s
  } captures[] = {{"reaching", projectFile("data/scenes/hug_reach.bvh"), 0.0},
                  {"boxing", debianBvh("Boxing_Toes.bvh"), 6.0},
                  {"waving", mocap("fair1_wave_hello.bvh"), 1.0},
                  {"walking", mocap("bvhtoolbox_walk01.bvh"), 0.0},
                  {"jumping", mocap("cmu_jumping_jacks_3dsmax_names.bvh"), 1.0},
                  {"sitting", sharedData("kinect/uiprmd_kinect_v2/m05_s01_e01_positions.txt"), 0.0}};
  std::vector<CapturedScene> scenes;
  for (const auto& [name, recording, start] : captures)
    for (const auto& [suffix, eye] : eightSides())
      scenes.push_back(
          {name + suffix,
           {.recording = recording, .start = start, .end = start + kLong, .eye = eye, .width = 240}});
  return scenes;
}

}  // namespace abstand::testing
