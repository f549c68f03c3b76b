// Comparison of costs, decay.
#include "tracking/tracker/limb_alternatives.hpp"

#include <algorithm>
#include <cmath>

namespace abstand::tracking {

void LimbAlternatives::begin(double t) {
  const double dt = t - last_t_;
  const double kept = dt > 0.0 ? std::exp(-dt / kDecay) : 1.0;
  for (double& distance : distance_) distance *= kept;
  last_t_ = t;
}

void LimbAlternatives::add(std::size_t limb, std::span<const LimbTry> tries, double cost,
                           const RigPlacement& X_WS) {
  const Vector3d& middle = X_WS[index(kLimbs[limb].lower)].translation();
  const Vector3d& end = X_WS[index(kLimbs[limb].end)].translation();
  double of_middle = 0.0, of_end = 0.0;
  for (const LimbTry& other : tries) {
    if (other.cost > cost + (kAlike - 1.0) * std::max(cost, kDoubtfulCost)) continue;
    of_middle = std::max(of_middle, (other.middle - middle).norm());
    of_end = std::max(of_end, (other.end - end).norm());
  }
  const auto count = [&](humanmodel::Joint joint, double distance) {
    double& largest = distance_[static_cast<std::size_t>(joint)];
    if (distance >= kFar) largest = std::max(largest, distance);
  };
  count(kLimbJoints[limb][1], of_middle);
  count(kLimbJoints[limb][2], of_end);
  count(kLimbJoints[limb][3], of_end);
}

void LimbAlternatives::forget() {
  distance_.fill(0.0);
  last_t_ = kNaN;
}

}  // namespace abstand::tracking
