// A URDF as plain values: the fence around urdfdom.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/geometry/shape.hpp"
#include "core/mechanism/mechanism.hpp"
#include "core/robot_file/urdf_text.hpp"

namespace abstand::robot_file {

struct UrdfGeometry {
  Transform X_LG{Transform::Identity()};  ///< in the link's frame
  std::string mesh;                       ///< empty for a shape
  Vector3d scale{Vector3d::Ones()};
  std::optional<geometry::Shape> shape;
};

struct UrdfLink {
  mechanism::LinkInertia inertia;  ///< in the link's frame
  std::vector<UrdfGeometry> visuals, collisions;
};

enum class UrdfJointType { kRevolute, kContinuous, kPrismatic, kFixed, kFloating, kPlanar };

struct UrdfJoint {
  UrdfJointType type{UrdfJointType::kFixed};
  Transform X_PJ{Transform::Identity()};  ///< joint, and child link at zero, in the parent link's frame
  Vector3d axis{Vector3d::UnitX()};       ///< unit vector
  mechanism::JointLimits limits;
  double multiplier{1.0}, offset{0.0};  ///< of a joint that mimics another
};

/// Links and joints stand in the order of the text.
struct UrdfModel {
  std::vector<UrdfLink> links;
  std::vector<UrdfJoint> joints;
};

/// A limit of this size means none: URDF has no other word for it.
inline constexpr double kUrdfNoLimit = 1e6;

/// Reads the document with urdfdom, whose log goes nowhere but into the error. Throws ParseError at `file`.
/// Safe from several threads.
UrdfModel readUrdf(const UrdfText& text, const std::string& file);

}  // namespace abstand::robot_file
