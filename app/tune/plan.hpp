// Which people do what beside which robots: the runs of a study of margins.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "app/scene_file/scene_description.hpp"

namespace abstand::tune {

/// In place of the people of a scene; what is not set stays as the scene says.
struct PersonVariant {
  std::optional<double> height, mass;  ///< m, kg
  /// Per cent, as in HumanOptions. Height and mass of the scene then give way to those of the percentile.
  std::optional<double> percentile;
  std::optional<humanmodel::Sex> sex;

  void apply(humanmodel::HumanOptions& body) const;
};

/// Where and how the person does what was recorded.
struct RecordingVariant {
  bool mirrored{false};              ///< with the other hand
  Vector3d shift{Vector3d::Zero()};  ///< m, world, beside the place of the scene
  double turn{0.0};                  ///< rad, about the vertical axis through the recording's origin

  void apply(scene_file::RecordingDescription& recording) const;
};

/// One recording, one person, one program of the robots.
struct PlanItem {
  std::filesystem::path scene, recording;  ///< no recording: people follow those of the scene
  PersonVariant person;
  RecordingVariant variant;
  double speed{1.0};                                     ///< of the person: 2, twice as fast as recorded
  std::map<std::string, std::filesystem::path> motions;  ///< of mechanisms by name, in place of the scene's
  /// "a.bvh, height 1.62, speed 1.2": unique in a plan.
  std::string name;

  /// Makes the scene that of this item. Throws UsageError for a mechanism that the scene does not have.
  void apply(scene_file::SceneDescription& description) const;
};

/// Reads a plan file (docs/margins.md, "Plans"): every recording with every person, speed and program. Throws
/// ParseError with line and column for what is wrong, a file that is missing and two runs of one name.
std::vector<PlanItem> loadPlan(const std::filesystem::path& file);

/// The same for a text; `file` names it in errors, and paths are relative to its folder.
std::vector<PlanItem> parsePlan(const std::string& text, const std::filesystem::path& file);

/// The first key is `abstand_plan`: no scene but a plan. False for what cannot be read.
bool isPlan(const std::filesystem::path& file);

}  // namespace abstand::tune
