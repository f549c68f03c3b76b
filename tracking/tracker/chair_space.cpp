// Planes from the joints of the person.
#include "tracking/tracker/chair_space.hpp"

#include <algorithm>

#include "tracking/tracker/seat_points.hpp"

namespace abstand::tracking {
namespace {

constexpr double kDeep = 0.45;        // m behind the axis of the trunk
constexpr double kUnderKnees = 0.3;   // m ahead of the hips; the calves are farther ahead
constexpr double kLowestSeat = 0.38;  // m, of the hips of a person on a chair
constexpr double kMaxLean = 0.6;      // of people who lean back or bend forward

}  // namespace

std::optional<ChairSpace> ChairSpace::of(const BodyRig& rig, const RigPlacement& X_WS) {
  using enum humanmodel::Joint;
  if (!sitsOnSeat(rig, X_WS)) return std::nullopt;
  const auto at = [&](humanmodel::Joint joint) { return jointPosition(rig, X_WS, joint); };
  ChairSpace chair;
  chair.hips_ = 0.5 * (at(kHipLeft) + at(kHipRight));
  const Vector3d knees = 0.5 * (at(kKneeLeft) + at(kKneeRight)), neck = at(kNeck);
  const Eigen::Vector2d ahead = (knees - chair.hips_).head<2>();
  if (ahead.norm() < 1e-6 || chair.hips_.z() < kLowestSeat) return std::nullopt;
  chair.ahead_ = ahead.normalized();
  const double up = neck.z() - chair.hips_.z();
  if (up < 0.1) return std::nullopt;
  chair.lean_ = std::clamp(chair.ahead_.dot((neck - chair.hips_).head<2>()) / up, -kMaxLean, kMaxLean);
  chair.level_ = std::min(chair.hips_.z(), knees.z()) - kUnderThighs;
  chair.neck_ = neck.z();
  chair.back_ = 0.5 * geometry::bounds(rig[RigSegment::kChest].shape).extent().x();
  return chair;
}

bool ChairSpace::holds(const Vector3d& p_W) const {
  const Vector3d p = p_W - hips_;
  const double ahead = ahead_.dot(p.head<2>()), aside = ahead_.x() * p.y() - ahead_.y() * p.x();
  if (std::abs(aside) > kHalfSeat || p_W.z() > neck_) return false;
  const double of_trunk = ahead - lean_ * std::max(0.0, p.z());
  if (of_trunk < -kDeep) return false;
  return of_trunk < -back_ || (p_W.z() < level_ && ahead < kUnderKnees);
}

}  // namespace abstand::tracking
