// Common fields of bodies in a scene file: shape, pose, scale and settings. Internal to the scene reader.
#pragma once

#include "app/scene_file/scene_description.hpp"
#include "core/config/yaml_reader.hpp"

namespace abstand::scene_file {

/// Ranges of voxels, points and layers: as HapticOptions::validate, but errors have a position in the file.
inline constexpr config::YamlRange kVoxelRange{1e-5, 10.0, "m"};
inline constexpr config::YamlRange kMarginRange{0.0, 10.0, "m"};
inline constexpr config::YamlRange kSpeedRange{0.0, 1e4, "m/s"};
inline constexpr config::YamlRange kPositionRange{-1e4, 1e4, "m"};
inline constexpr config::YamlRange kAngleRange{-1e3, 1e3, "rad"};
inline constexpr config::YamlRange kScaleRange{0.0, 1e6, "", true};
inline constexpr int kMaxOuterLayers = 10000;

/// `key: true` or `key: false`; false if absent.
bool readFlag(const config::YamlFields& fields, const char* key);

/// The map `key` with `xyz` (m) and `rpy` (rad); the identity if absent.
Transform readPose(const config::YamlFields& parent, std::string_view key);

/// `scale` of a mesh: one number, or one for each axis.
Vector3d readScale(const config::YamlFields& fields);

/// `voxel`, `point`, `margin`, `outer_layers` and `max_speed`, if present.
BodySettings readSettings(const config::YamlFields& fields);

/// The single shape in the map `shape`.
geometry::Shape readShape(const config::YamlNode& node, const std::string& file);

}  // namespace abstand::scene_file
