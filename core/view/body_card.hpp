// What never changes of bodies, robots and people of an open scene, for the window.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "core/math/transform.hpp"

namespace abstand::view {

/// Geometry of a body as it is checked.
struct BodyCard {
  Vector3d size{Vector3d::Zero()};  ///< m, extents of its surface along its own axes
  std::size_t shell_points{0};
  double point_spacing{0.0}, voxel_size{0.0};  ///< m
  double error_bound{0.0};                     ///< m, see HapticStructure::errorBound()
};

/// A mechanism of the scene.
struct RobotCard {
  std::string name;
  std::string file;    ///< with its folder
  std::string motion;  ///< file of its motion, with its folder; empty: it rests
  Transform X_WB{Transform::Identity()};
  int first_joint{0}, joints{0};  ///< its joints in SceneOutline::joints
};

/// A person of the scene, as modelled.
struct PersonCard {
  std::string name;
  double stature{0.0};               ///< m
  double mass{0.0};                  ///< kg
  std::string sex;                   ///< "f", "m"; empty: mean of both
  std::optional<double> percentile;  ///< per cent, of girths, breadths and depths; none: mean sizes
  std::string recording;             ///< file that moves the person; empty: none
  /// Place of the recording in the world: origin (m) and turn about z (rad).
  Vector3d place_xyz{Vector3d::Zero()};
  double place_yaw{0.0};
};

/// Why two bodies of the scene are no pair.
enum class UncheckedReason : std::uint8_t {
  kAdjacent,   ///< they share a joint, or nothing moves them relative to each other
  kOnePerson,  ///< parts of one person, which the scene does not ask for
  kOneGroup,   ///< of one robot, or both objects, which the scene does not ask for
  kListed,     ///< dropped by an SRDF or a file of pairs; the note says why
  kExcluded,   ///< named under `exclude`, or not under `include` where the scene begins without pairs
};

/// Two bodies (indices a < b of SceneOutline::objects) that are never checked against each other.
struct UncheckedPair {
  int a{0}, b{0};
  UncheckedReason reason{UncheckedReason::kExcluded};
  int note{-1};  ///< index into SceneOutline::unchecked_notes; -1: none
};

}  // namespace abstand::view
