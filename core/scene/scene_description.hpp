// A scene file as plain values, before anything is loaded.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/error.hpp"
#include "core/geometry/shape.hpp"
#include "core/haptic/haptic_options.hpp"
#include "core/scene/skipping.hpp"

namespace abstand {

/// What a body of the scene may set for itself; what is not set follows `defaults`.
struct BodySettings {
  std::optional<double> voxel, point, margin;
  std::optional<double> max_speed;  ///< m/s
  std::optional<int> outer_layers;
};

struct LinkDescription {
  std::string name;
  int frame{0};                ///< id of the frame it moves with; 0: the base
  std::filesystem::path mesh;  ///< absolute; empty when a shape is given
  double scale{1.0};
  std::optional<Shape> shape;
  Transform X_FL{Transform::Identity()};  ///< link in its frame (`pose`)
  BodySettings settings;
  SourcePos pos;
};

struct MechanismDescription {
  std::string name;
  std::filesystem::path file;
  Transform X_WB{Transform::Identity()};  ///< `base`
  std::vector<double> q;                  ///< empty: all zero
  std::filesystem::path motion;           ///< empty: none
  std::optional<double> max_speed;        ///< m/s, of its links, where they have none of their own
  std::vector<LinkDescription> links;
  SourcePos pos;
};

struct RecordingDescription {
  std::filesystem::path file;  ///< empty: stands in the rest pose
  std::string format{"auto"}, units{"auto"}, up{"auto"};
  Vector3d place_xyz{Vector3d::Zero()};  ///< where the recording's origin goes
  double place_yaw{0.0};                 ///< rad, about world z
  SourcePos pos;
};

/// Overrides of one part: key ("contour", "length", "breadth", "depth", "margin", "voxel", "point",
/// "max_speed") -> value.
struct HumanPartDescription {
  std::map<std::string, double> numbers;
  std::optional<std::string> shape;
};

struct HumanDescription {
  std::string name;
  double height{1.75};
  std::optional<double> mass;
  std::optional<std::string> sex;  ///< "f" or "m"
  std::string preset{"anthropometric"};
  BodySettings settings;
  bool follow_lengths{false};  ///< `lengths: recording`
  std::map<std::string, HumanPartDescription> parts;
  RecordingDescription recording;
  SourcePos pos;
};

struct ObjectDescription {
  std::string name;
  std::filesystem::path mesh;
  double scale{1.0};
  std::optional<Shape> shape;
  Transform X_WB{Transform::Identity()};
  BodySettings settings;
  SourcePos pos;
};

enum class PairDefault { kAll, kBetweenGroups, kNone };

struct PairsDescription {
  PairDefault standard{PairDefault::kAll};
  bool exclude_adjacent{true};
  std::vector<std::pair<std::string, std::string>> exclude, include;
  std::vector<SourcePos> exclude_pos, include_pos;
};

struct SceneDefaults {
  HapticOptions haptic;
  double margin{0.0};
  double stiffness{1.0e6};  ///< N/m^3, or N/m with `law: thesis`
  bool thesis_law{false};
};

/// Live mode's groups of pairs, a thread each; empty: chosen by the program (`threads: auto`).
using ThreadGroups = std::vector<std::vector<std::pair<std::string, std::string>>>;

struct SceneDescription {
  std::filesystem::path file;
  SceneDefaults defaults;
  std::vector<MechanismDescription> mechanisms;
  std::vector<HumanDescription> humans;
  std::vector<ObjectDescription> objects;
  PairsDescription pairs;
  ThreadGroups threads;
  Skipping skipping;
};

/// Reads a scene file (cli contract, YAML). Relative paths are resolved against the scene file's folder.
/// Throws ParseError with file, line and column; unknown keys come with the nearest known one, missing files
/// at their line.
SceneDescription loadScene(const std::filesystem::path& file);
SceneDescription parseScene(const std::string& text, const std::filesystem::path& file);

/// The scene as it was understood, as YAML that reads back the same.
std::string describeScene(const SceneDescription& scene);

}  // namespace abstand
