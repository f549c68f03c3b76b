#include "abstand/mechanism.hpp"

#include "core/base/error.hpp"
#include "core/facade/structure_impl.hpp"
#include "core/mechanism/dof_limits.hpp"
#include "core/robot_file/mesh_reference.hpp"
#include "core/robot_file/robot.hpp"

namespace abstand {

struct Mechanism::Impl {
  robot_file::Robot robot;
  std::vector<LinkBody> bodies;
  std::vector<const mechanism::MechanismFrame*> leaders;  ///< of each joint value
  std::vector<mechanism::DofLimits> limits;
};

namespace {

LinkBody bodyOf(const robot_file::LinkGeometry& geometry, robot_file::MeshFinder& finder) {
  LinkBody body;
  body.frame = geometry.frame;
  body.collision = geometry.use == robot_file::GeometryUse::kCollision;
  body.X_FG = geometry.X_FG;
  if (geometry.shape) {
    body.shape = facade::shapeOf(*geometry.shape);
    return body;
  }
  body.mesh_name = geometry.mesh;
  body.mesh = finder.find(geometry.mesh).value_or(std::filesystem::path());
  body.scale = geometry.scale;
  return body;
}

mechanism::MechanismState stateAt(const mechanism::Mechanism& m, std::span<const double> q) {
  if (q.size() != static_cast<std::size_t>(m.dof))
    throw UsageError("found " + std::to_string(q.size()) + " joint values for '" + m.name + "', expected " +
                     std::to_string(m.dof));
  mechanism::MechanismState state;
  mechanism::forward(m, q, state);
  return state;
}

}  // namespace

Mechanism Mechanism::load(const std::filesystem::path& file,
                          const std::vector<std::filesystem::path>& packages) {
  auto impl = std::make_shared<Impl>();
  impl->robot = robot_file::loadRobot(file);
  robot_file::MeshFinder finder(file, {.folders = packages});
  for (const auto& geometry : impl->robot.geometry) impl->bodies.push_back(bodyOf(geometry, finder));
  const mechanism::Mechanism& m = impl->robot.mechanism;
  impl->leaders.assign(static_cast<std::size_t>(m.dof), nullptr);
  for (const auto& frame : m.frames)
    if (frame.dof >= 0 && !frame.mimic) impl->leaders[static_cast<std::size_t>(frame.dof)] = &frame;
  impl->limits = mechanism::dofLimits(m);
  return Mechanism(std::move(impl));
}

const std::string& Mechanism::name() const { return impl_->robot.mechanism.name; }
int Mechanism::dof() const { return impl_->robot.mechanism.dof; }
std::size_t Mechanism::frames() const { return impl_->robot.mechanism.frames.size(); }
std::string Mechanism::frameName(std::size_t frame) const {
  return impl_->robot.mechanism.frames.at(frame).name;
}
int Mechanism::parent(std::size_t frame) const { return impl_->robot.mechanism.frames.at(frame).parent; }
int Mechanism::frame(const std::string& name) const { return impl_->robot.mechanism.indexOf(name); }

JointLimits Mechanism::limits(int value) const {
  if (value < 0 || value >= dof()) throw UsageError("found no joint value " + std::to_string(value));
  const mechanism::DofLimits& l = impl_->limits[static_cast<std::size_t>(value)];
  return {l.lower, l.upper, l.velocity, l.effort};
}

std::string Mechanism::jointName(int value) const {
  if (value < 0 || value >= dof()) throw UsageError("found no joint value " + std::to_string(value));
  const auto* frame = impl_->leaders[static_cast<std::size_t>(value)];
  return frame ? frame->joint : std::string();
}

const std::vector<LinkBody>& Mechanism::bodies() const { return impl_->bodies; }
const std::vector<std::string>& Mechanism::warnings() const { return impl_->robot.warnings; }

std::vector<Pose> Mechanism::forward(std::span<const double> q) const {
  const mechanism::MechanismState state = stateAt(impl_->robot.mechanism, q);
  return {state.X_BF.begin(), state.X_BF.end()};
}

Eigen::Matrix<double, 6, Eigen::Dynamic> Mechanism::jacobian(std::span<const double> q,
                                                             std::size_t frame) const {
  const mechanism::Mechanism& m = impl_->robot.mechanism;
  if (frame >= m.frames.size()) throw UsageError("found no frame " + std::to_string(frame));
  Eigen::Matrix<double, 6, Eigen::Dynamic> J(6, m.dof);
  mechanism::jacobian(m, stateAt(m, q), static_cast<int>(frame), J);
  return J;
}

}  // namespace abstand
