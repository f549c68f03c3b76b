// What bodies of a scene file have in common: shape, pose, scale and settings. Internal to the scene reader.
#pragma once

#include "app/scene_file/scene_description.hpp"
#include "core/config/yaml_reader.hpp"

namespace abstand::scene_file {

/// Voxels, points and layers: as HapticOptions::validate, but with the place in the file.
inline constexpr config::YamlRange kVoxelRange{1e-5, 10.0, "m"};
inline constexpr config::YamlRange kMarginRange{0.0, 10.0, "m"};
inline constexpr config::YamlRange kSpeedRange{0.0, 1e4, "m/s"};
inline constexpr config::YamlRange kPositionRange{-1e4, 1e4, "m"};
inline constexpr config::YamlRange kAngleRange{-1e3, 1e3, "rad"};
inline constexpr config::YamlRange kScaleRange{0.0, 1e6, "", true};
inline constexpr int kMaxOuterLayers = 10000;

/// `key: true` or `key: false`; false where it is not there.
bool readFlag(const config::YamlFields& fields, const char* key);

/// The map `key` of `xyz` (m) and `rpy` (rad); the identity where it is not there.
Transform readPose(const config::YamlFields& parent, std::string_view key);

/// `scale` of a mesh: one number, or one for each axis.
Vector3d readScale(const config::YamlFields& fields);

/// `voxel`, `point`, `margin`, `outer_layers` and `max_speed`, where they are among the fields.
BodySettings readSettings(const config::YamlFields& fields);

/// The one shape that the map `shape` holds.
geometry::Shape readShape(const config::YamlNode& node, const std::string& file);

}  // namespace abstand::scene_file
