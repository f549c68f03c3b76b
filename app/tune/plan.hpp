// Plan of a margin study: combinations of people, recordings and robot programs.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "app/scene_file/scene_description.hpp"

namespace abstand::tune {

/// Overrides for the people of a scene; unset values stay as in the scene.
struct PersonVariant {
  std::optional<double> height, mass;  ///< m, kg
  /// Per cent, as in HumanOptions. Replaces stature and mass of the scene by those of the percentile.
  std::optional<double> percentile;
  std::optional<humanmodel::Sex> sex;

  void apply(humanmodel::HumanOptions& body) const;
};

/// Variation of a recorded motion.
struct RecordingVariant {
  bool mirrored{false};              ///< left and right exchanged
  Vector3d shift{Vector3d::Zero()};  ///< m, world, added to the scene's position
  double turn{0.0};                  ///< rad, about the vertical axis through the recording's origin

  void apply(scene_file::RecordingDescription& recording) const;
};

/// What people wear and hold in addition to the scene.
struct WornVariant {
  humanmodel::Clothing clothing;
  std::vector<scene_file::ToolDescription> tools;

  /// Throws UsageError for a tool whose name is taken.
  void apply(scene_file::HumanDescription& human) const;
};

/// One run: recording, person and robot program.
struct PlanItem {
  std::filesystem::path scene, recording;  ///< no recording: people follow those of the scene
  PersonVariant person;
  RecordingVariant variant;
  double speed{1.0};                                     ///< of the person, factor of the recorded speed
  std::map<std::string, std::filesystem::path> motions;  ///< of mechanisms by name, instead of the scene's
  /// "a.bvh, height 1.62, speed 1.2": unique in a plan.
  std::string name;
  WornVariant worn{};
  WornVariant worn_always{};  ///< of the command line: in addition, not in the name

  /// Applies this item to the scene. Throws UsageError for an unknown mechanism and two tools of one name.
  void apply(scene_file::SceneDescription& description) const;
};

/// Reads a plan file (docs/margins.md, "Plans"): the product of recordings, people, speeds and programs.
/// Throws ParseError with line and column for errors, missing files and two runs with the same name.
std::vector<PlanItem> loadPlan(const std::filesystem::path& file);

/// The same for a text; `file` is its name in errors, and its folder the base of paths.
std::vector<PlanItem> parsePlan(const std::string& text, const std::filesystem::path& file);

/// True if the first key is `abstand_plan`: a plan instead of a scene. False for unreadable files.
bool isPlan(const std::filesystem::path& file);

}  // namespace abstand::tune
