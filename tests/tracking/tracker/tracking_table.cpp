// Prints the table of errors and coverage of docs/tracking.md.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <functional>
#include <string>

#include "core/base/output_file.hpp"
#include "tests/tracking/tracker/beside_things.hpp"
#include "tests/tracking/tracker/captured_scenes.hpp"
#include "tests/tracking/tracker/certified_clip.hpp"
#include "tests/tracking/tracker/posed_scenes.hpp"
#include "tests/tracking/tracker/random_scenes.hpp"
#include "tests/tracking/tracker/work_sessions.hpp"
#include "tracking/depth/formats/depth_png.hpp"
#include "tracking/table/skeleton_csv.hpp"
#include "tracking/tracker/clip_tracker.hpp"
#include "tracking/tracker/live_tracker.hpp"

namespace abstand::testing {
namespace {

tracking::ClipTrackerOptions g_options;
bool g_live = false;

struct TableClip {
  std::string name;
  std::function<SimulatedClip(std::size_t camera)> make;
  std::string remark{};  ///< printed behind the name
  std::size_t cameras{1};

  std::vector<SimulatedClip> clips() const {
    std::vector<SimulatedClip> clips;
    for (std::size_t c = 0; c < cameras; ++c) clips.push_back(make(c));
    return clips;
  }
};

/// The processor time of the live tracker is not measured: its result has 0 s.
tracking::ClipTrack trackOf(std::span<const SimulatedClip> clips) {
  std::vector<tracking::ClipCamera> streams;
  std::vector<tracking::DepthCamera> cameras;
  for (const SimulatedClip& clip : clips) {
    streams.push_back({clip.stream.get(), 0.0});
    cameras.push_back(clip.stream->camera());
  }
  if (!g_live) return tracking::trackClips(streams, g_options);
  tracking::LiveTrackerOptions options;
  options.person = g_options.person;
  tracking::LiveTracker tracker(cameras, true, options);
  tracking::DepthMoments moments(streams);
  tracking::DepthMoment moment;
  while (moments.next(moment)) tracker.see(moment);
  return tracker.track();
}

std::vector<TableClip> clipsOf(const std::vector<CapturedScene>& scenes) {
  std::vector<TableClip> clips;
  for (const CapturedScene& scene : scenes)
    if (exists(scene.plan.recording))
      clips.push_back({scene.name, [scene](std::size_t) { return simulate(scene); }});
  return clips;
}

std::vector<TableClip> clipsOf(const std::vector<PosedScene>& scenes) {
  std::vector<TableClip> clips;
  for (const PosedScene& scene : scenes)
    clips.push_back({scene.name, [scene](std::size_t) { return simulate(scene); }});
  return clips;
}

/// Of --random: seed and number of clips, which are the only group then, and of cameras.
std::uint64_t g_random_seed = 0;
int g_random_count = 0;
std::size_t g_random_cameras = 1;

std::vector<std::pair<const char*, std::vector<TableClip>>> groups() {
  if (g_random_count > 0) {
    std::vector<TableClip> clips;
    for (const RandomScene& scene : randomScenes(g_random_seed, g_random_count))
      clips.push_back({scene.name, scene.make, ": " + scene.remark, g_random_cameras});
    return {{"random clips", clips}};
  }
  return {{"hard captures", clipsOf(hardScenes())},
          {"captures", clipsOf(capturedScenes())},
          {"captures from all sides", clipsOf(scenesFromAllSides())},
          {"postures", clipsOf(posedScenes())},
          {"held-out postures", clipsOf(heldOutScenes())},
          {"other statures", clipsOf(otherStatures())},
          {"raised hands", clipsOf(raisedScenes())},
          {"postures from all sides", clipsOf(posturesFromAllSides())},
          {"people beside things", clipsOf(scenesBesideThings())},
          {"people close to things", clipsOf(scenesCloseToThings())},
          {"sessions of half a minute", clipsOf(workSessions())},
          {"postures from other places", clipsOf(posturesFromOtherPlaces())}};
}

/// Whether half of the joints are in the image, hidden or not.
bool isInView(const tracking::DepthCamera& camera, const humanmodel::SkeletonFrame& frame) {
  const Transform X_CW = camera.X_WC.inverse();
  int joints = 0, seen = 0;
  for (std::size_t j = 0; j < humanmodel::kJointCount; ++j) {
    if (!frame.has(static_cast<humanmodel::Joint>(j))) continue;
    ++joints;
    const Vector3d p_C = X_CW * frame.p[j];
    if (p_C.z() <= 0.0) continue;
    const Eigen::Vector2d pixel = camera.pixelOf(p_C);
    seen += pixel.x() >= 0.0 && pixel.x() < camera.width && pixel.y() >= 0.0 && pixel.y() < camera.height;
  }
  return 2 * seen >= joints;
}

/// Of the person found in the most images: the errors, and in how many of the images that show half of the
/// joints or more.
struct ClipResult {
  JointErrors errors;
  std::size_t found{0}, images{0};
};

/// The cameras of the clips stand still where their files say: whatever is said of them is wrong.
void printAlarms(const std::string& name, const tracking::ClipTrack& track) {
  if (track.people.size() > 1)
    std::fprintf(stderr, "%s: %zu people were found, expected one\n", name.c_str(), track.people.size());
  for (std::size_t c = 0; c < track.cameras.size(); ++c) {
    const tracking::CameraShare& camera = track.cameras[c];
    if (std::isfinite(camera.moved_at))
      std::fprintf(stderr, "%s: camera %zu was taken for moved\n", name.c_str(), c + 1);
    if (std::isfinite(camera.apart_since))
      std::fprintf(stderr, "%s: camera %zu was said to be off by %.2f m\n", name.c_str(), c + 1,
                   camera.apart);
    if (std::isfinite(camera.late_since))
      std::fprintf(stderr, "%s: camera %zu was said to be late by %.2f s\n", name.c_str(), c + 1,
                   camera.late);
  }
}

ClipResult resultOf(const TableClip& named, double& images_a_second) {
  const std::vector<SimulatedClip> clips = named.clips();
  const tracking::ClipTrack track = trackOf(clips);
  images_a_second = static_cast<double>(track.images) / track.seconds;
  printAlarms(named.name, track);
  ClipResult result;
  for (const humanmodel::SkeletonFrame& truth : clips[0].truth) {
    if (std::none_of(clips.begin(), clips.end(),
                     [&](const SimulatedClip& clip) { return isInView(clip.stream->camera(), truth); }))
      continue;
    ++result.images;
    if (track.people.empty()) continue;
    const auto& frames = track.people[0].frames;
    result.found += std::any_of(frames.begin(), frames.end(), [&](const humanmodel::SkeletonFrame& frame) {
      return std::abs(frame.t - truth.t) < 1e-6 && frame.has(humanmodel::Joint::kPelvis);
    });
  }
  if (!track.people.empty()) result.errors = compare(track.people[0].frames, clips[0].truth);
  return result;
}

void printStated(const JointErrors::Stated& stated) {
  if (stated.error.empty())
    std::printf(" none |");
  else
    std::printf(" %.3f, x %.1f; %.3f, x %.1f (%zu) |", stated.within(), stated.medianRatio(),
                stated.withinLargest(), stated.medianRatioOfLargest(), stated.error.size());
}

void printRow(const std::string& name, const ClipResult& result) {
  const JointErrors& errors = result.errors;
  std::vector<double> seen = errors.tracked.error;
  std::sort(seen.begin(), seen.end());
  if (result.images == 0) return;
  std::printf("| %s | %zu of %zu |", name.c_str(), result.found, result.images);
  if (seen.empty())
    std::printf(" none |");
  else
    std::printf(" %.0f; %.0f |", 1e3 * JointErrors::mean(seen), 1e3 * JointErrors::quantile(seen, 0.95));
  printStated(errors.tracked);
  printStated(errors.inferred);
  std::printf("\n");
  std::fflush(stdout);
}

constexpr double kSlice = 0.5;  // s

/// For each half second, the mean raw error of each joint in mm; in brackets where it was inferred.
void printJoints(const TableClip& named) {
  const std::vector<SimulatedClip> clips = named.clips();
  const SimulatedClip& clip = clips[0];
  const tracking::ClipTrack track = trackOf(clips);
  if (track.people.empty()) return;
  const std::vector<humanmodel::SkeletonFrame>& frames = track.people[0].frames;
  std::printf("%s\n", named.name.c_str());
  for (std::size_t j = 0; j < humanmodel::kJointCount; ++j) {
    const auto joint = static_cast<humanmodel::Joint>(j);
    std::printf("%-14s", std::string(humanmodel::jointName(joint)).c_str());
    for (double t = clip.truth.front().t; t <= clip.truth.back().t; t += kSlice) {
      double sum = 0.0;
      int count = 0, inferred = 0;
      for (const humanmodel::SkeletonFrame& f : frames) {
        if (f.t < t || f.t >= t + kSlice || !f.has(joint)) continue;
        const auto truth = std::find_if(clip.truth.begin(), clip.truth.end(),
                                        [&](const auto& o) { return std::abs(o.t - f.t) < 1e-6; });
        if (truth == clip.truth.end()) continue;
        sum += (f[joint] - (*truth)[joint]).norm();
        ++count;
        inferred += f.state[j] == humanmodel::JointState::kInferred;
      }
      std::printf(2 * inferred > count ? " (%3.0f)" : "  %3.0f ", count > 0 ? 1e3 * sum / count : kNaN);
    }
    std::printf("\n");
  }
}

int printJoints(const std::vector<std::string>& chosen) {
  for (const auto& [group, clips] : groups())
    for (const TableClip& named : clips)
      if (std::find(chosen.begin(), chosen.end(), named.name) != chosen.end()) printJoints(named);
  return 0;
}

void printCertified(const std::string& name, const CertifiedDistances& of) {
  if (of.truth.empty()) return;
  std::printf("| %s | %.4f (%zu) | %.0f | %.0f; %.0f |\n", name.c_str(), of.held(), of.truth.size(),
              1e3 * of.largestViolation(), 1e3 * CertifiedDistances::medianSlack(of.certified, of.truth),
              1e3 * CertifiedDistances::medianSlack(of.of_radius, of.truth));
  std::fflush(stdout);
}

/// For each clip, certified distances of a person in a scene against the true ones.
int printCertified(const std::vector<std::string>& chosen) {
  std::printf(
      "| clip | share of certified <= true distance (images x balls) | largest certified - true distance, mm "
      "| "
      "median of true - certified distance, mm; with the largest axis |\n|---|---|---|---|\n");
  for (const auto& [group, clips] : groups()) {
    CertifiedDistances of_group;
    for (const TableClip& named : clips) {
      if (!chosen.empty() && std::find(chosen.begin(), chosen.end(), named.name) == chosen.end()) continue;
      const std::vector<SimulatedClip> clips_of = named.clips();
      const CertifiedDistances of = certifiedDistances(clips_of[0], trackOf(clips_of));
      printCertified(named.name + named.remark, of);
      of_group.add(of);
    }
    printCertified("**all " + std::string(group) + "**", of_group);
  }
  return 0;
}

/// As files for `abstand track`, with the true joints.
void writeClip(const std::filesystem::path& folder, SimulatedClip clip) {
  create_directories(folder);
  const tracking::DepthCamera& camera = clip.stream->camera();
  writeFile(folder / "camera.yaml", tracking::describeDepthCamera(camera));
  std::string list;
  tracking::DepthFrame frame;
  for (std::size_t i = 0; clip.stream->next(frame); ++i) {
    char name[40], line[80];
    std::snprintf(name, sizeof name, "depth_%06zu.png", i);
    std::snprintf(line, sizeof line, "%.6f %s\n", frame.t, name);
    tracking::saveDepthPng(frame.image, camera.depth_scale, folder / name);
    list += line;
  }
  writeFile(folder / "depth.txt", list);
  tracking::Recording truth;
  truth.frames = clip.truth;
  tracking::writeSkeletonCsv(folder / "truth.csv", truth);
}

/// A folder for each clip; for each further camera "NAME_camera_2".
int writeClips(const std::filesystem::path& into, const std::vector<std::string>& chosen) {
  for (const auto& [group, clips] : groups())
    for (const TableClip& named : clips) {
      if (std::find(chosen.begin(), chosen.end(), named.name) == chosen.end()) continue;
      for (std::size_t c = 0; c < named.cameras; ++c)
        writeClip(into / (named.name + (c > 0 ? "_camera_" + std::to_string(c + 1) : "")), named.make(c));
    }
  return 0;
}

int printNames() {
  for (const auto& [group, clips] : groups())
    for (const TableClip& named : clips) std::printf("%s\t%s\n", group, named.name.c_str());
  return 0;
}

int printTable(const std::vector<std::string>& chosen) {
  std::printf(
      "| clip | images with the body | tracked joints, raw error: mean; 95 %%, mm | tracked within the "
      "ellipsoid, median of its "
      "size "
      "toward the error / error; the same of its largest axis (joints) | inferred, likewise |\n"
      "|---|---|---|---|---|\n");
  ClipResult all;
  const auto add = [](const ClipResult& from, ClipResult& to) {
    to.errors.tracked.add(from.errors.tracked);
    to.errors.inferred.add(from.errors.inferred);
    to.found += from.found;
    to.images += from.images;
  };
  for (const auto& [group, clips] : groups()) {
    ClipResult of_group;
    double slowest = kInfinity;
    for (const TableClip& clip : clips) {
      if (!chosen.empty() && std::find(chosen.begin(), chosen.end(), clip.name) == chosen.end()) continue;
      double rate = 0.0;
      const ClipResult result = resultOf(clip, rate);
      slowest = std::min(slowest, rate);
      printRow(clip.name + clip.remark, result);
      add(result, of_group);
    }
    printRow("**all " + std::string(group) + "**", of_group);
    if (std::isfinite(slowest))
      std::fprintf(stderr, "%s: %.0f images a second in the slowest clip\n", group, slowest);
    add(of_group, all);
  }
  printRow("**all**", all);
  return 0;
}

}  // namespace
}  // namespace abstand::testing

/// Arguments: names of clips, none: all of them; --joints or --certified and names; --write, a folder and
/// names; or --names. First of all, in this order: --live, for the results of a live camera; --seed and a
/// number, for another random search for limbs; --cameras and a number, with which drawn clips are seen;
/// --random, a seed and a number of clips, for drawn ones.
int main(int argc, char** argv) {
  if (argc > 1 && std::strcmp(argv[1], "--live") == 0) {
    abstand::testing::g_live = true;
    --argc;
    ++argv;
  }
  if (argc > 2 && std::strcmp(argv[1], "--seed") == 0) {
    abstand::testing::g_options.person.seed = std::strtoull(argv[2], nullptr, 10);
    argc -= 2;
    argv += 2;
  }
  if (argc > 2 && std::strcmp(argv[1], "--cameras") == 0) {
    abstand::testing::g_random_cameras = std::strtoull(argv[2], nullptr, 10);
    argc -= 2;
    argv += 2;
  }
  if (argc > 3 && std::strcmp(argv[1], "--random") == 0) {
    abstand::testing::g_random_seed = std::strtoull(argv[2], nullptr, 10);
    abstand::testing::g_random_count = std::atoi(argv[3]);
    argc -= 3;
    argv += 3;
  }
  if (argc > 1 && std::strcmp(argv[1], "--names") == 0) return abstand::testing::printNames();
  if (argc > 3 && std::strcmp(argv[1], "--write") == 0)
    return abstand::testing::writeClips(argv[2], {argv + 3, argv + argc});
  if (argc > 1 && std::strcmp(argv[1], "--joints") == 0)
    return abstand::testing::printJoints({argv + 2, argv + argc});
  if (argc > 1 && std::strcmp(argv[1], "--certified") == 0)
    return abstand::testing::printCertified({argv + 2, argv + argc});
  return abstand::testing::printTable({argv + 1, argv + argc});
}
