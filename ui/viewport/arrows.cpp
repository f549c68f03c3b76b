// Forces, torques and velocities of all objects as arrows.
#include "ui/viewport/arrows.hpp"

#include <algorithm>

#include "ui/theme.hpp"

namespace abstand::ui {

namespace {

constexpr double kLongest = 0.40;          // m, straight arrows
constexpr double kLargestArc = 0.16;       // m, radius of a torque's arc
constexpr double kShortest = 0.06;         // m, so that an arrow can be seen as one
constexpr double kSmallestArc = 0.04;      // m
constexpr double kForceRadius = 0.012;     // m
constexpr double kVelocityRadius = 0.004;  // m

/// Factor from value to length, and the largest arrow for the legend.
double scaleFor(double largest, double longest, double fixed, bool automatic, ArrowScale& scale) {
  const double factor = automatic && largest > 0.0 ? longest / largest : fixed;
  scale = {std::min(largest * factor, longest), largest};
  if (!automatic && largest > 0.0) scale.value = scale.metres / factor;
  return factor;
}

}  // namespace

void Arrows::open(const SceneOutline& outline) {
  const auto n = static_cast<int>(outline.objects.size());
  forces_ = std::make_unique<ArrowBatch>(ArrowBatch::Shape::kStraight, n, renderer_);
  torques_ = std::make_unique<ArrowBatch>(ArrowBatch::Shape::kCurved, n, renderer_);
  velocities_ = std::make_unique<ArrowBatch>(ArrowBatch::Shape::kStraight, n, renderer_);
  forces_->setColour(QColor(0xffc0342b));
  torques_->setColour(QColor(kBlue));
  velocities_->setColour(QColor(kCyan));
  contact_points_.assign(outline.objects.size(), Vector3d::Zero());
  weights_.assign(outline.objects.size(), 0.0);
}

void Arrows::findContactPoints(const SceneOutline& outline, const SceneSnapshot& snapshot) {
  std::fill(contact_points_.begin(), contact_points_.end(), Vector3d::Zero());
  std::fill(weights_.begin(), weights_.end(), 0.0);
  const auto add = [&](int object, const Vector3d& p_W, double weight) {
    if (!(weight > 0.0) || !p_W.allFinite()) return;
    contact_points_[static_cast<std::size_t>(object)] += weight * p_W;
    weights_[static_cast<std::size_t>(object)] += weight;
  };
  for (std::size_t p = 0; p < std::min(outline.pairs.size(), snapshot.pairs.size()); ++p) {
    const PairResult& result = snapshot.pairs[p].result;
    const double weight = result.force_a.norm();
    add(outline.pairs[p].first, result.witness_a, weight);
    add(outline.pairs[p].second, result.witness_b, weight);
  }
  for (std::size_t i = 0; i < weights_.size(); ++i)
    contact_points_[i] =
        weights_[i] > 0.0 ? Vector3d(contact_points_[i] / weights_[i]) : snapshot.objects[i].p_WCom;
}

bool Arrows::refresh(const SceneOutline& outline, const SceneSnapshot& snapshot, const ViewOptions& options) {
  if (!forces_ || snapshot.objects.size() != weights_.size()) return false;
  findContactPoints(outline, snapshot);
  double most_force = 0.0, most_torque = 0.0, most_speed = 0.0;
  for (const ObjectSnapshot& object : snapshot.objects) {
    if (options.forces) most_force = std::max(most_force, object.contact.force.norm());
    if (options.torques) most_torque = std::max(most_torque, object.contact.torque.norm());
    if (options.velocities) most_speed = std::max(most_speed, object.velocity.linear.norm());
  }
  if (most_force < options.least_force) most_force = 0.0;
  if (most_torque < options.least_torque) most_torque = 0.0;
  if (most_speed < options.least_speed) most_speed = 0.0;
  const bool automatic = options.auto_scale;
  const double per_newton = scaleFor(most_force, kLongest, options.metres_per_newton, automatic, force_);
  const double per_newton_metre =
      scaleFor(most_torque, kLargestArc, options.metres_per_newton_metre, automatic, torque_);
  const double per_speed =
      scaleFor(most_speed, kLongest, options.metres_per_metre_per_second, automatic, velocity_);

  forces_->begin();
  torques_->begin();
  velocities_->begin();
  for (std::size_t i = 0; i < snapshot.objects.size(); ++i) {
    const ObjectSnapshot& object = snapshot.objects[i];
    const auto arrow = [](ArrowBatch& batch, const Vector3d& p_W, const Vector3d& v, double least,
                          double factor, double shortest, double longest, double radius) {
      const double size = v.norm();
      if (size >= least) batch.add(p_W, v / size, std::clamp(size * factor, shortest, longest), radius);
    };
    if (options.forces)
      arrow(*forces_, contact_points_[i], object.contact.force, options.least_force, per_newton, kShortest,
            kLongest, kForceRadius);
    if (options.torques)
      arrow(*torques_, object.p_WCom, object.contact.torque, options.least_torque, per_newton_metre,
            kSmallestArc, kLargestArc, 0.0);
    if (options.velocities)
      arrow(*velocities_, object.p_WCom, object.velocity.linear, options.least_speed, per_speed, kShortest,
            kLongest, kVelocityRadius);
  }
  bool changed = forces_->finish();
  changed |= torques_->finish();
  changed |= velocities_->finish();
  return changed;
}

}  // namespace abstand::ui
