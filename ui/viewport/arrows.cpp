// Forces, torques and velocities of all objects as arrows.
#include "ui/viewport/arrows.hpp"

#include <algorithm>
#include <cmath>

#include "ui/model/pair_level.hpp"
#include "ui/style/theme.hpp"

namespace abstand::ui {

namespace {

constexpr double kLongest = 0.40;          // m, straight arrows
constexpr double kLargestArc = 0.16;       // m, radius of a torque's arc
constexpr double kShortest = 0.06;         // m, so that an arrow can be seen as one
constexpr double kSmallestArc = 0.04;      // m
constexpr double kForceRadius = 0.012;     // m
constexpr double kVirtualRadius = 0.006;   // m, of forces of the margins
constexpr double kVelocityRadius = 0.004;  // m

/// Factor from value to length, and the largest arrow for the legend.
double scaleFor(double largest, double longest, double fixed, bool automatic, ArrowScale& scale) {
  const double factor = automatic && largest > 0.0 ? longest / largest : fixed;
  scale = {std::min(largest * factor, longest), largest};
  if (!automatic && largest > 0.0) scale.value = scale.metres / factor;
  return factor;
}

}  // namespace

void Arrows::open(const view::SceneOutline& outline) {
  const auto n = static_cast<int>(outline.objects.size());
  for (auto& batch : forces_)
    batch = std::make_unique<ArrowBatch>(ArrowBatch::Shape::kStraight, n, renderer_);
  torques_ = std::make_unique<ArrowBatch>(ArrowBatch::Shape::kCurved, n, renderer_);
  velocities_ = std::make_unique<ArrowBatch>(ArrowBatch::Shape::kStraight, n, renderer_);
  const auto joints = static_cast<int>(outline.joints.size());
  joint_torques_ = std::make_unique<ArrowBatch>(ArrowBatch::Shape::kCurved, joints, renderer_);
  joint_forces_ = std::make_unique<ArrowBatch>(ArrowBatch::Shape::kStraight, joints, renderer_);
  joint_torques_->setColour(QColor(kViolet));
  joint_forces_->setColour(QColor(kViolet));
  forces_[kReal]->setColour(QColor(kContactForce));
  forces_[kVirtual]->setColour(QColor(kVirtualForce));
  torques_->setColour(QColor(kBlue));
  velocities_->setColour(QColor(kCyan));
  for (auto& pushes : pushes_) pushes.assign(outline.objects.size(), {});
}

void Arrows::sumForces(const view::SceneOutline& outline, const view::SceneSnapshot& snapshot) {
  for (auto& pushes : pushes_) std::fill(pushes.begin(), pushes.end(), Push{});
  for (std::size_t p = 0; p < std::min(outline.pairs.size(), snapshot.pairs.size()); ++p) {
    const view::PairSnapshot& pair = snapshot.pairs[p];
    const query::PairResult& result = pair.result;
    if (pair.paused || result.contacts == 0) continue;
    auto& pushes = pushes_[isTouching(result) ? kReal : kVirtual];
    const double weight = result.force_a.norm();
    const auto add = [&](int object, const Vector3d& force, const Vector3d& p_W) {
      Push& push = pushes[static_cast<std::size_t>(object)];
      push.force += force;
      if (!(weight > 0.0) || !p_W.allFinite()) return;
      push.point += weight * p_W;
      push.weight += weight;
    };
    add(outline.pairs[p].first, result.force_a, result.witness_a);
    add(outline.pairs[p].second, -result.force_a, result.witness_b);
  }
  for (auto& pushes : pushes_)
    for (std::size_t i = 0; i < pushes.size(); ++i)
      pushes[i].point =
          pushes[i].weight > 0.0 ? Vector3d(pushes[i].point / pushes[i].weight) : snapshot.objects[i].p_WCom;
}

void Arrows::addJoints(const view::SceneSnapshot& snapshot, const ViewOptions& options) {
  joint_torques_->begin();
  joint_forces_->begin();
  const std::size_t joints =
      options.joint_torques ? std::min(snapshot.movers.joint_axes.size(), snapshot.joint_torques.size()) : 0;
  double max_torque = 0.0, max_force = 0.0;
  for (std::size_t j = 0; j < joints; ++j) {
    double& largest = snapshot.movers.joint_axes[j].prismatic ? max_force : max_torque;
    largest = std::max(largest, std::abs(snapshot.joint_torques[j].contact));
  }
  if (max_torque < options.min_torque) max_torque = 0.0;
  if (max_force < options.min_force) max_force = 0.0;
  const double per_newton_metre =
      scaleFor(max_torque, kLargestArc, options.metres_per_newton_metre, options.auto_scale, joint_torque_);
  const double per_newton =
      scaleFor(max_force, kLongest, options.metres_per_newton, options.auto_scale, joint_force_);
  for (std::size_t j = 0; j < joints; ++j) {
    const mechanism::JointAxis& axis = snapshot.movers.joint_axes[j];
    const double effort = snapshot.joint_torques[j].contact, size = std::abs(effort);
    const Vector3d direction = effort < 0.0 ? Vector3d(-axis.direction) : axis.direction;
    if (axis.prismatic && size >= options.min_force)
      joint_forces_->add(axis.p, direction, std::clamp(size * per_newton, kShortest, kLongest), kForceRadius);
    if (!axis.prismatic && size >= options.min_torque)
      joint_torques_->add(axis.p, direction, std::clamp(size * per_newton_metre, kSmallestArc, kLargestArc),
                          0.0);
  }
}

bool Arrows::refresh(const view::SceneOutline& outline, const view::SceneSnapshot& snapshot,
                     const ViewOptions& options) {
  if (!torques_ || snapshot.objects.size() != pushes_[kReal].size()) return false;
  sumForces(outline, snapshot);
  std::array<double, kKinds> most{};
  double max_force = 0.0, max_torque = 0.0, max_speed = 0.0;
  for (const view::ObjectSnapshot& object : snapshot.objects) {
    if (options.torques) max_torque = std::max(max_torque, object.contact.torque.norm());
    if (options.velocities) max_speed = std::max(max_speed, object.velocity.linear.norm());
  }
  if (options.forces)
    for (std::size_t kind = 0; kind < kKinds; ++kind) {
      for (const Push& push : pushes_[kind]) most[kind] = std::max(most[kind], push.force.norm());
      if (most[kind] < options.min_force) most[kind] = 0.0;
      max_force = std::max(max_force, most[kind]);
    }
  if (max_torque < options.min_torque) max_torque = 0.0;
  if (max_speed < options.min_speed) max_speed = 0.0;
  const bool automatic = options.auto_scale;
  // One scale for both kinds; a kind that is not in sight has no line in the legend.
  ArrowScale scale;
  const double per_newton = scaleFor(max_force, kLongest, options.metres_per_newton, automatic, scale);
  for (std::size_t kind = 0; kind < kKinds; ++kind)
    force_scale_[kind] = most[kind] > 0.0 ? scale : ArrowScale{};
  const double per_newton_metre =
      scaleFor(max_torque, kLargestArc, options.metres_per_newton_metre, automatic, torque_);
  const double per_speed =
      scaleFor(max_speed, kLongest, options.metres_per_metre_per_second, automatic, velocity_);

  for (auto& batch : forces_) batch->begin();
  torques_->begin();
  velocities_->begin();
  for (std::size_t i = 0; i < snapshot.objects.size(); ++i) {
    const view::ObjectSnapshot& object = snapshot.objects[i];
    const auto arrow = [](ArrowBatch& batch, const Vector3d& p_W, const Vector3d& v, double least,
                          double factor, double shortest, double longest, double radius) {
      const double size = v.norm();
      if (size >= least) batch.add(p_W, v / size, std::clamp(size * factor, shortest, longest), radius);
    };
    if (options.forces)
      for (std::size_t kind = 0; kind < kKinds; ++kind)
        arrow(*forces_[kind], pushes_[kind][i].point, pushes_[kind][i].force, options.min_force, per_newton,
              kShortest, kLongest, kind == kReal ? kForceRadius : kVirtualRadius);
    if (options.torques)
      arrow(*torques_, object.p_WCom, object.contact.torque, options.min_torque, per_newton_metre,
            kSmallestArc, kLargestArc, 0.0);
    if (options.velocities)
      arrow(*velocities_, object.p_WCom, object.velocity.linear, options.min_speed, per_speed, kShortest,
            kLongest, kVelocityRadius);
  }
  addJoints(snapshot, options);
  bool changed = joint_torques_->finish();
  changed |= joint_forces_->finish();
  for (auto& batch : forces_) changed |= batch->finish();
  changed |= torques_->finish();
  changed |= velocities_->finish();
  return changed;
}

}  // namespace abstand::ui
