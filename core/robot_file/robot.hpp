// A robot: its mechanism and the geometry of its links.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/error.hpp"
#include "core/geometry/shape.hpp"
#include "core/mechanism/mechanism.hpp"

namespace abstand::robot_file {

enum class GeometryUse { kCollision, kVisual };

/// One geometry of a link: a mesh or a shape, in the link's frame.
struct LinkGeometry {
  int frame{-1};  ///< index into Mechanism::frames, -1: the base
  GeometryUse use{GeometryUse::kCollision};
  std::string mesh;                  ///< reference as in the file (mesh_reference.hpp); empty for a shape
  Vector3d scale{Vector3d::Ones()};  ///< of the mesh, metres per unit; may be negative (mirrored), never 0
  std::optional<geometry::Shape> shape;  ///< empty for a mesh
  Transform X_FG{Transform::Identity()};
  SourcePos pos;
};

/// A visual of a frame that cannot be read.
struct UnreadGeometry {
  int frame{-1};
  std::string reason;  ///< "found the geometry 'capsule' in <visual>, expected ..."
};

/// Content of a robot file. Constant after loading.
struct Robot {
  std::filesystem::path file;
  mechanism::Mechanism mechanism;
  std::vector<LinkGeometry> geometry;  ///< in file order
  std::vector<std::string> warnings;   ///< unusual but readable content, `FILE:LINE:COLUMN: TEXT`
  std::vector<UnreadGeometry> unread;  ///< not in `geometry`; each with a warning
};

inline constexpr std::uintmax_t kMaxRobotBytes = 16u << 20;

/// Reads a `.mech` file (mech_file.hpp) or a URDF (urdf_file.hpp), selected by content: XML begins with '<'.
/// Meshes are not opened and need not exist. Throws ParseError.
Robot loadRobot(const std::filesystem::path& file);

}  // namespace abstand::robot_file
