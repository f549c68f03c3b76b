#include "tracking/tracker/facing_trial.hpp"

#include <algorithm>
#include <cmath>

namespace abstand::tracking {
namespace {

// Exponents, and costs of an image (m^2) that are added to both, so that small ones do not decide. The noise
// of the images grows with the square of the distance: the second one is that at kDistance (m).
constexpr double kLowPower = 0.2, kLowFloor = 5e-3;
constexpr double kEmptyPower = 0.4, kEmptyFloor = 1e-6, kDistance = 2.8;

}  // namespace

void FacingTrial::Sums::add(const FacingEvidence& evidence, bool feet_count) {
  cost += evidence.cost;
  if (!feet_count) return;
  low_cost += evidence.low_cost;
  empty_cost += evidence.empty_cost;
  low_points += evidence.low_points;
  square_distance += evidence.distance * evidence.distance;
}

void FacingTrial::add(double t, const FacingEvidence& camera, const FacingEvidence& away) {
  ++images_;
  const bool feet_count = !away.kneels;
  if (feet_count) ++images_of_feet_;
  if (camera.kneels || away.kneels) ++images_on_knees_;
  if (camera.shows_little || away.shows_little) ++images_of_little_;
  camera_.add(camera, feet_count);
  away_.add(away, feet_count);
  const Vector3d p_W = 0.5 * (camera.p_WP + away.p_WP);
  if (std::abs(t - last_t_) < kLongestStep) {
    const Vector3d step = t > last_t_ ? Vector3d(p_W - last_p_) : Vector3d(last_p_ - p_W);
    camera_.walked += step.dot(camera.forward_W);
    away_.walked += step.dot(away.forward_W);
  }
  last_t_ = t;
  last_p_ = p_W;
}

double FacingTrial::feetFactor() const {
  const auto images = static_cast<double>(images_of_feet_);
  if (2 * images_of_feet_ < images_ || camera_.low_points < kMinLowPoints * images) return 1.0;
  const double low_floor = kLowFloor * images;
  const double empty_floor = kEmptyFloor * camera_.square_distance / (kDistance * kDistance);
  const auto favoursCamera = [](double away, double camera, double floor, double power) {
    return std::max(1.0, std::pow((away + floor) / (camera + floor), power));
  };
  return favoursCamera(away_.low_cost, camera_.low_cost, low_floor, kLowPower) *
         favoursCamera(away_.empty_cost, camera_.empty_cost, empty_floor, kEmptyPower);
}

double FacingTrial::walkingFactor() const {
  const double forward = 0.5 * (camera_.walked - away_.walked);
  const double share = std::clamp((std::abs(forward) - kWalks) / (kWalksFar - kWalks), 0.0, 1.0);
  return std::pow(kMaxOfWalking, std::copysign(share, forward));
}

double FacingTrial::ratio() const {
  if (images_ == 0) return kNaN;
  return away_.cost / camera_.cost * feetFactor() * walkingFactor();
}

void FacingTrial::judge(Facing& facing) const {
  if (images_ < kMinImages && !(images_ >= kFewImages && clearness() > kClear)) return;
  facing.ratio = ratio();
  facing.kneels = 2 * images_on_knees_ > images_;
  facing.shows_little = 2 * images_of_little_ > images_;
}

}  // namespace abstand::tracking
