// Where a seat with a back is, under and behind a person who sits.
#pragma once

#include <optional>

#include "tracking/body/body_rig.hpp"
#include "tracking/tracker/body_view.hpp"

namespace abstand::tracking {

/// Space of the chair of a person who sits (sitsOnSeat()), from the floor to the neck: under the thighs, and
/// behind the back. Vertical planes bound it; the one in front of the back leans as the trunk does.
class ChairSpace {
 public:
  /// nullopt if the person of this pose does not sit.
  static std::optional<ChairSpace> of(const BodyRig& rig, const RigPlacement& X_WS);

  bool holds(const Vector3d& p_W) const;

 private:
  Vector3d hips_{Vector3d::Zero()};  ///< m, world, between both hip joints
  Eigen::Vector2d ahead_{1.0, 0.0};  ///< unit, from the hips to the knees
  double lean_{0.0};                 ///< of the trunk: m ahead for each m upwards
  double level_{0.0}, neck_{0.0};    ///< m, world z: under the thighs; of the neck
  double back_{0.0};                 ///< m behind the axis of the trunk: its surface
};

/// m, misfit of a point of the chair: larger than that of a person's surface, smaller than that of a surface
/// which is not of the person at all.
inline constexpr float kChairMisfit = 0.03f;

}  // namespace abstand::tracking
