#include "core/robot_file/urdf_model.hpp"

#include <console_bridge/console.h>
#include <urdf_parser/urdf_parser.h>

#include <cmath>
#include <mutex>

#include "core/base/error.hpp"

namespace abstand::robot_file {
namespace {

/// Captures urdfdom's log. console_bridge has one handler for the whole process.
class SilentLog final : public console_bridge::OutputHandler {
 public:
  SilentLog() : level_(console_bridge::getLogLevel()), before_(console_bridge::getOutputHandler()) {
    console_bridge::setLogLevel(console_bridge::CONSOLE_BRIDGE_LOG_ERROR);
    console_bridge::useOutputHandler(this);
  }
  ~SilentLog() override {
    console_bridge::useOutputHandler(before_);
    console_bridge::setLogLevel(level_);
  }
  void log(const std::string& text, console_bridge::LogLevel, const char*, int) override {
    if (first_.empty()) first_ = text.substr(0, text.find('\n'));
  }
  const std::string& first() const { return first_; }

 private:
  console_bridge::LogLevel level_;
  console_bridge::OutputHandler* before_;
  std::string first_;
};

Vector3d vectorOf(const urdf::Vector3& v) { return {v.x, v.y, v.z}; }

Transform poseOf(const urdf::Pose& pose) {
  Transform X = Transform::Identity();
  const urdf::Rotation& r = pose.rotation;
  X.linear() = Quaterniond(r.w, r.x, r.y, r.z).normalized().toRotationMatrix();
  X.translation() = vectorOf(pose.position);
  return X;
}

template <class Body>
std::vector<UrdfGeometry> geometriesOf(const std::vector<std::shared_ptr<Body>>& bodies) {
  std::vector<UrdfGeometry> geometries;
  for (const auto& body : bodies) {
    UrdfGeometry& g = geometries.emplace_back();
    g.X_LG = poseOf(body->origin);
    if (const auto* mesh = dynamic_cast<const urdf::Mesh*>(body->geometry.get())) {
      g.mesh = mesh->filename;
      g.scale = vectorOf(mesh->scale);
    } else if (const auto* box = dynamic_cast<const urdf::Box*>(body->geometry.get())) {
      g.shape = geometry::Cuboid{vectorOf(box->dim)};
    } else if (const auto* sphere = dynamic_cast<const urdf::Sphere*>(body->geometry.get())) {
      g.shape = geometry::Sphere{sphere->radius};
    } else {
      const auto& cylinder = dynamic_cast<const urdf::Cylinder&>(*body->geometry);
      g.shape = geometry::Cylinder{cylinder.radius, cylinder.length};
    }
  }
  return geometries;
}

UrdfLink linkOf(const urdf::Link& link) {
  UrdfLink out;
  if (link.inertial) {
    const urdf::Inertial& i = *link.inertial;
    const Transform X_LI = poseOf(i.origin);
    Matrix3d I;
    I << i.ixx, i.ixy, i.ixz, i.ixy, i.iyy, i.iyz, i.ixz, i.iyz, i.izz;
    out.inertia = {i.mass, X_LI.translation(), X_LI.linear() * I * X_LI.linear().transpose()};
  }
  out.visuals = geometriesOf(link.visual_array);
  out.collisions = geometriesOf(link.collision_array);
  return out;
}

UrdfJointType typeOf(const urdf::Joint& joint) {
  switch (joint.type) {
    case urdf::Joint::REVOLUTE:
      return UrdfJointType::kRevolute;
    case urdf::Joint::CONTINUOUS:
      return UrdfJointType::kContinuous;
    case urdf::Joint::PRISMATIC:
      return UrdfJointType::kPrismatic;
    case urdf::Joint::FLOATING:
      return UrdfJointType::kFloating;
    case urdf::Joint::PLANAR:
      return UrdfJointType::kPlanar;
    default:
      return UrdfJointType::kFixed;
  }
}

UrdfJoint jointOf(const urdf::Joint& joint) {
  UrdfJoint out;
  out.type = typeOf(joint);
  out.X_PJ = poseOf(joint.parent_to_joint_origin_transform);
  if (out.type != UrdfJointType::kFixed && out.type != UrdfJointType::kFloating)
    out.axis = vectorOf(joint.axis).normalized();
  if (joint.limits) {
    const auto known = [](double v) { return std::abs(v) < kUrdfNoLimit ? v : std::copysign(kInfinity, v); };
    out.limits.velocity = known(joint.limits->velocity);
    out.limits.effort = known(joint.limits->effort);
    if (out.type != UrdfJointType::kContinuous && joint.limits->lower <= joint.limits->upper) {
      out.limits.lower = known(joint.limits->lower);
      out.limits.upper = known(joint.limits->upper);
    }
  }
  if (joint.mimic) {
    out.multiplier = joint.mimic->multiplier;
    out.offset = joint.mimic->offset;
  }
  return out;
}

}  // namespace

UrdfModel readUrdf(const UrdfText& text, const std::string& file) {
  static std::mutex one_at_a_time;
  const std::scoped_lock lock(one_at_a_time);
  const SilentLog log;
  try {
    const auto model = urdf::parseURDF(text.document);
    if (!model)
      throw ParseError({file}, "found a URDF that urdfdom rejects, expected one that it reads", log.first());
    UrdfModel out;
    for (const auto& link : text.links) out.links.push_back(linkOf(*model->links_.at(link.name)));
    for (const auto& joint : text.joints) out.joints.push_back(jointOf(*model->joints_.at(joint.name)));
    return out;
  } catch (const ParseError&) {
    throw;
  } catch (const std::exception& e) {
    const std::string what = e.what();
    throw ParseError({file}, "found a URDF that urdfdom rejects, expected one that it reads",
                     what.substr(0, what.find('\n')));
  }
}

}  // namespace abstand::robot_file
