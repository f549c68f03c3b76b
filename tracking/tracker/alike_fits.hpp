// Fits from other starts that explain an image about as well.
#pragma once

#include <array>

#include "tracking/body/body_rig.hpp"

namespace abstand::tracking {

/// m, for each joint.
using JointRadii = std::array<double, humanmodel::kJointCount>;

/// Bodies that were fitted to one image. Bent people look alike in several poses, as with the head at either
/// end of the back. Not shared between threads; no allocation, no throw.
class AlikeFits {
 public:
  explicit AlikeFits(const BodyRig& rig) : rig_{&rig} {}
  /// `cost`: of DepthFit, m^2. The most expensive of more than kMax fits are left out.
  void add(double cost, const RigPlacement& X_WS);
  /// For each joint, the distance of the farthest place in a fit that costs less than kAlike times the
  /// cheapest one, from that in the cheapest one; of another place, with its own error. 0 without fits.
  JointRadii apart() const;

  static constexpr std::size_t kMax = 16;
  static constexpr double kAlike = 1.5;
  static constexpr double kOwnError = 0.15;  ///< m

 private:
  struct Fit {
    double cost;
    std::array<Vector3d, humanmodel::kJointCount> p;  ///< m, world
  };
  const BodyRig* rig_;
  std::array<Fit, kMax> fits_;
  std::size_t count_{0};
};

}  // namespace abstand::tracking
