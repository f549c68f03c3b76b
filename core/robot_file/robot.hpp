// A robot file: the mechanism, and the geometry that its links have.
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
  std::string mesh;                  ///< as the file names it (mesh_reference.hpp); empty when a shape
  Vector3d scale{Vector3d::Ones()};  ///< of the mesh, metres per unit; may be negative (mirrored), never 0
  std::optional<geometry::Shape> shape;  ///< nothing for a mesh
  Transform X_FG{Transform::Identity()};
  SourcePos pos;
};

/// A visual that the file has for a frame and that cannot be read.
struct UnreadGeometry {
  int frame{-1};
  std::string reason;  ///< "found the geometry 'capsule' in <visual>, expected ..."
};

/// What a robot file holds. Constant after loading.
struct Robot {
  std::filesystem::path file;
  mechanism::Mechanism mechanism;
  std::vector<LinkGeometry> geometry;  ///< in file order
  std::vector<std::string> warnings;   ///< what is odd but can be read, `FILE:LINE:COLUMN: TEXT`
  std::vector<UnreadGeometry> unread;  ///< left out of `geometry`, with a warning
};

inline constexpr std::uintmax_t kMaxRobotBytes = 16u << 20;

/// Reads a `.mech` file (mech_file.hpp) or a URDF (urdf_file.hpp), told apart by content: XML begins with
/// '<'. Meshes are not opened and need not be there. Throws ParseError.
Robot loadRobot(const std::filesystem::path& file);

}  // namespace abstand::robot_file
