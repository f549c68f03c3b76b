#include "tests/app/tune/margin_clips.hpp"

#include <cmath>
#include <numbers>

namespace abstand::testing {
namespace {

namespace fs = std::filesystem;

std::unique_ptr<session::Session> opened(scene_file::SceneDescription scene, const fs::path& recording,
                                         double person_speed) {
  // Coarse bodies are made in no time; the laws are the same.
  scene.defaults.haptic.voxel_size = scene.defaults.haptic.point_spacing = 0.02;
  for (auto& o : scene.objects) o.settings.voxel = o.settings.point = 0.04;
  session::SessionOptions options;
  options.recording = recording;
  options.person_speed = person_speed;
  options.threads = 1;
  options.cache = false;
  options.rest = 0.0;
  return depth::openSession(std::move(scene), options);
}

/// Joint values that swing: amplitudes (rad or m), all with one period (s), for a minute.
void writeSwing(const ScratchFolder& folder, const std::vector<double>& amplitudes, double period) {
  std::string text = "t";
  for (std::size_t j = 0; j < amplitudes.size(); ++j) text += ",q" + std::to_string(j);
  text += "\n";
  for (int i = 0; i <= 6000; ++i) {
    const double t = 0.01 * i;
    text += formatDouble(t);
    for (std::size_t j = 0; j < amplitudes.size(); ++j)
      text += "," + formatDouble(amplitudes[j] *
                                 std::sin(2.0 * std::numbers::pi * t / period + static_cast<double>(j)));
    text += "\n";
  }
  folder.write("swing.csv", text);
}

struct Place {
  double x, y, yaw;  ///< m, rad
};

std::string personAt(const fs::path& recording, const Place& place) {
  return "humans:\n  - {name: person, height: 1.75, recording: {file: " + recording.string() +
         ", place: {xyz: [" + formatDouble(place.x) + ", " + formatDouble(place.y) +
         ", 0], yaw: " + formatDouble(place.yaw) + "}}}\n";
}

/// An arm of two joints that sweeps a horizontal plane at the height of the hands.
fs::path writeArm(const ScratchFolder& folder, double period, const fs::path& recording, const Place& place) {
  folder.write("arm.mech",
               "units\nlength m\nangle degrees\nend_units\nmapping\ndof 0 1\ndof 1 2\nend_mapping\nchain\n"
               "frame 1 0 0 0 theta\nframe 2 0.4 0 0 theta\nend_chain\n");
  writeSwing(folder, {0.7, 0.9}, period);
  return folder.write("arm.yaml", R"(abstand: 1
defaults: {voxel: 0.02, point: 0.02, outer_layers: 1}
mechanisms:
  - name: arm
    file: arm.mech
    base: {xyz: [0, 0, 1.1]}
    motion: swing.csv
    links:
      - {name: upper, frame: 1, shape: {capsule: {radius: 0.06, length: 0.4}}, pose: {xyz: [0.2, 0, 0], rpy: [0, 1.5707963, 0]}}
      - {name: lower, frame: 2, shape: {capsule: {radius: 0.05, length: 0.4}}, pose: {xyz: [0.2, 0, 0], rpy: [0, 1.5707963, 0]}}
)" + personAt(recording, place));
}

/// A ball that goes to and fro along y through the origin, at the height of the hips.
fs::path writeRail(const ScratchFolder& folder, double period, const fs::path& recording,
                   const Place& place) {
  folder.write("rail.mech",
               "units\nlength m\nangle degrees\nend_units\nmapping\ndof 0 1\nend_mapping\nchain\n"
               "frame 1 0 90 d 0\nend_chain\n");
  writeSwing(folder, {0.9}, period);
  return folder.write("rail.yaml", R"(abstand: 1
defaults: {voxel: 0.02, point: 0.02, outer_layers: 1}
mechanisms:
  - name: rail
    file: rail.mech
    base: {xyz: [0, 0, 1.0]}
    motion: swing.csv
    links: [{name: ball, frame: 1, shape: {sphere: {radius: 0.08}}}]
)" + personAt(recording, place));
}

MarginClip walk(const std::string& name, const SlideSpeeds& speeds, const tune::BrakingOptions& braking,
                double limit = 0.0) {
  return {name, braking, limit, 0.0, {}, {}, [speeds](const ScratchFolder& folder) {
            return openSlide(folder, speeds);
          }};
}

/// The person who reaches (data/scenes/hug_reach.bvh), so much faster.
MarginClip reach(const std::string& name, double arm_period, double person_speed,
                 const tune::BrakingOptions& braking, double restart_time = 0.0) {
  return {name, braking, 0.0, restart_time, {}, {}, [=](const ScratchFolder& folder) {
            const fs::path scene = writeArm(folder, arm_period, projectFile("data/scenes/hug_reach.bvh"),
                                            {1.05, 0.15, -std::numbers::pi / 2.0});
            return opened(scene_file::loadScene(scene), {}, person_speed);
          }};
}

/// A shipped scene, perhaps with another recording.
MarginClip shipped(const std::string& name, const std::string& scene, const std::string& recording,
                   double start, double end, const tune::BrakingOptions& braking, double person_speed = 1.0) {
  return {name, braking, 0.0, 0.0, start, end, [=](const ScratchFolder&) {
            return opened(scene_file::loadScene(projectFile("data/scenes/" + scene)),
                          recording.empty() ? fs::path() : projectFile(recording), person_speed);
          }};
}

/// The shipped six-axis arm with a person who reaches beside it.
MarginClip atArm6(const std::string& name, double x, double person_speed,
                  const tune::BrakingOptions& braking) {
  return {name, braking, 0.0, 0.0, {}, {}, [=](const ScratchFolder& folder) {
            const fs::path scene = folder.write(
                "arm6.yaml",
                "abstand: 1\ndefaults: {voxel: 0.02, point: 0.02}\nmechanisms:\n  - {name: arm6, file: " +
                    projectFile("data/robots/arm6/arm6.urdf").string() +
                    ", motion: " + projectFile("data/scenes/motion/arm6.csv").string() + "}\n" +
                    personAt(projectFile("data/scenes/hug_reach.bvh"), {x, 0.0, -std::numbers::pi / 2.0}));
            return opened(scene_file::loadScene(scene), {}, person_speed);
          }};
}

}  // namespace

tune::TuneOptions MarginClip::tune() const {
  tune::TuneOptions o;
  o.pass.braking = braking;
  o.pass.limit = limit;
  o.restart_time = restart_time;
  return o;
}

run::RunOptions MarginClip::run() const {
  run::RunOptions o;
  o.start = start;
  o.end = end;
  return o;
}

std::vector<MarginClip> walkingClips() {
  return {
      walk("walk_slow_robot", {.robot = 0.25, .person = 0.8}, {0.1, 5.0}),
      walk("walk_fast_robot", {.robot = 1.2, .person = 0.4}, {0.2, 3.0}),
      walk("walk_and_stop", {.robot = 0.1, .person = 0.8, .stops_at = 2.4}, {0.1, 5.0}),
      walk("walk_limit", {.robot = 0.5, .person = 0.5}, {0.1, 2.0}, 0.05),
      walk("walk_30_hz", {.robot = 0.6, .person = 0.9, .rate = 30.0}, {0.1, 2.0}),
      walk("walk_250_hz", {.robot = 0.6, .person = 0.9, .rate = 250.0, .seconds = 2.0}, {0.3, 1.0}),
      walk("walk_away", {.robot = 0.6, .person = -0.5}, {0.1, 2.0}),
      walk("stand", {.robot = 0.7}, {0.0, 1.5}),
  };
}

std::vector<MarginClip> reachingClips() {
  return {
      reach("reach", 4.0, 1.0, {0.1, 5.0}),
      reach("reach_fast", 4.0, 1.8, {0.1, 5.0}),
      reach("reach_slow_reaction", 4.0, 1.0, {0.4, 5.0}),
      reach("reach_weak_brakes", 3.0, 1.0, {0.1, 1.0}, 0.2),
      reach("reach_fast_arm", 1.5, 1.0, {0.1, 5.0}),
      reach("reach_slow_arm", 12.0, 0.6, {0.1, 5.0}, 0.5),
  };
}

std::vector<MarginClip> robotClips() {
  return {
      atArm6("arm6", 1.0, 1.0, {0.1, 5.0}),
      atArm6("arm6_near", 0.85, 1.4, {0.2, 2.0}),
      shipped("hug_reach", "hug_reach.yaml", "", 0.4, 3.8, {0.1, 5.0}),
      shipped("hug_reach_fast", "hug_reach.yaml", "", 0.2, 2.4, {0.2, 1.0}, 1.6),
      shipped("rail7", "rail7.yaml", "", 0.0, 2.5, {0.1, 5.0}),
      shipped("rail7_weak_brakes", "rail7.yaml", "", 4.0, 6.0, {0.3, 1.0}),
  };
}

std::vector<MarginClip> capturedClips() {
  std::vector<MarginClip> clips;
  const auto add = [&](const std::string& name, const fs::path& file, const Place& place, double start,
                       double end) {
    if (!fs::exists(file)) return;
    clips.push_back({name, {0.1, 3.0}, 0.0, 0.0, start, end, [=](const ScratchFolder& folder) {
                       return opened(scene_file::loadScene(writeRail(folder, 2.0, file, place)), {}, 1.0);
                     }});
  };
  add("boxing", debianBvh("Boxing_Toes.bvh"), {0.4, 0.0, 0.0}, 0.0, 3.0);
  add("cmu_01_01", debianBvh("01_01.bvh"), {0.0, 0.0, 0.0}, 0.1,
      4.0);  // after the T-pose that the converter put first
  add("cmu_12_01", sharedData("mocap/bvh/cmu_12_01_walk_motionbuilder.bvh"), {0.0, 0.0, 0.0}, 0.1, 4.0);
  add("walk01", sharedData("mocap/bvh/bvhtoolbox_walk01.bvh"), {0.0, 0.0, 0.0}, 0.0, 4.2);
  add("jumping_jacks", sharedData("mocap/bvh/cmu_jumping_jacks_3dsmax_names.bvh"), {0.5, 0.0, 0.0}, 0.0, 3.0);
  add("wave", sharedData("mocap/bvh/fair1_wave_hello.bvh"), {0.0, 0.0, 0.0}, 0.0, 4.0);
  add("dance", sharedData("mocap/bvh/rokoko_jesse_dance.bvh"), {0.0, 0.0, 0.0}, 0.0, 4.0);
  return clips;
}

}  // namespace abstand::testing
