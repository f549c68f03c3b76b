// A URDF as plain values; isolates urdfdom.
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
  Transform X_PJ{Transform::Identity()};  ///< the joint, and its child link at value 0, in the parent link's
                                          ///< frame
  Vector3d axis{Vector3d::UnitX()};       ///< unit vector
  mechanism::JointLimits limits;
  double multiplier{1.0}, offset{0.0};  ///< of a mimic joint
};

/// Links and joints are in file order.
struct UrdfModel {
  std::vector<UrdfLink> links;
  std::vector<UrdfJoint> joints;
};

/// A limit of this size or more means none: URDF has no other notation for it.
inline constexpr double kUrdfNoLimit = 1e6;

/// Parses the document with urdfdom; its log is only used for the error. Throws ParseError at `file`.
/// Thread-safe.
UrdfModel readUrdf(const UrdfText& text, const std::string& file);

}  // namespace abstand::robot_file
