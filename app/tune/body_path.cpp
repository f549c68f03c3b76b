#include "app/tune/body_path.hpp"

#include <algorithm>

#include "core/math/object_motion.hpp"

namespace abstand::tune {

void BodyPath::add(double t, const Transform& X_WB, double uncertainty) {
  if (!t_.empty()) {
    const double duration = t - t_.back();
    motion_.emplace_back(sphere_B_, X_WB_.back(), X_WB, duration);
    travelled_.push_back(travelled_.back() + motion_.back().speed(0.0, duration) * duration);
  } else {
    travelled_.push_back(0.0);
  }
  t_.push_back(t);
  X_WB_.push_back(X_WB);
  uncertainty_.push_back(uncertainty);
}

std::size_t BodyPath::indexAt(double t) const {
  const auto after = std::upper_bound(t_.begin(), t_.end(), t);
  return after == t_.begin() ? 0 : static_cast<std::size_t>(after - t_.begin()) - 1;
}

Transform BodyPath::at(double t) const {
  const std::size_t k = indexAt(t);
  if (k + 1 >= t_.size()) return X_WB_.back();
  safety::PoseSegment motion = motion_[k];
  return motion.pose(t - t_[k]);
}

double BodyPath::travelled(double t) const {
  const std::size_t k = indexAt(t);
  if (k + 1 >= t_.size()) return travelled_.back();
  const double share = std::clamp((t - t_[k]) / (t_[k + 1] - t_[k]), 0.0, 1.0);
  return travelled_[k] + share * (travelled_[k + 1] - travelled_[k]);
}

double BodyPath::reach(double t0, double t1) const {
  const double middle = 0.5 * (t0 + t1), here = travelled(middle);
  const double along = std::max(here - travelled(t0), travelled(t1) - here);
  // For a body that moves to and fro the distance of poses is a better bound than the path length.
  const std::size_t first = indexAt(t0), last = std::min(indexAt(t1) + 1, t_.size() - 1);
  if (last - first < 4) return along;
  const Transform X = at(middle);
  double farthest = 0.0, step = 0.0;
  for (std::size_t k = first; k <= last; ++k) {
    const double shift = (X_WB_[k] * sphere_B_.centre - X * sphere_B_.centre).norm();
    const double turn = rotationBetween(X.linear(), X_WB_[k].linear()).norm();
    farthest = std::max(farthest, shift + turn * sphere_B_.radius);
    if (k < last) step = std::max(step, travelled_[k + 1] - travelled_[k]);
  }
  return std::min(along, farthest + 0.5 * step);
}

double BodyPath::uncertainty(double t0, double t1) const {
  double most = 0.0;
  for (std::size_t k = indexAt(t0); k < t_.size() && t_[k] <= t1; ++k) most = std::max(most, uncertainty_[k]);
  return most;
}

}  // namespace abstand::tune
