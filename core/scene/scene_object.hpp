// A body in the scene.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "core/math/transform.hpp"
#include "core/query/pair_query.hpp"
#include "core/scene/speed_watch.hpp"

namespace abstand::scene {

/// Parameters of a new body.
struct ObjectSpec {
  std::string name;   ///< unique in the scene
  std::string group;  ///< name of a mechanism or human, or "objects"
  std::shared_ptr<const structure::HapticStructure> structure;
  double margin{0.0};  ///< m, safety margin
};

/// Reliability of an object's pose; all states except kFresh are shown and never count as safe.
enum class PoseState : std::uint8_t { kFresh, kInferred, kStale, kRejected };
/// The object may be anywhere else by now.
inline bool isPoseLost(PoseState state) {
  return state == PoseState::kStale || state == PoseState::kRejected;
}

/// One body of the scene with its recent motion and total contact wrench. World frame.
struct Object {
  ObjectSpec spec;
  Transform X_WB{Transform::Identity()};
  PoseState pose_state{PoseState::kFresh};
  /// m: every point of the body is within this of its position by X_WB; added to the margins when distances
  /// are judged. Infinite: the position is unknown.
  double pose_uncertainty{0.0};
  /// m^2, world axes: no point is displaced along a unit vector d by more than pose_age_uncertainty +
  /// sqrt(d . E d), either. Zero: only the radius is known. directedUncertainty() uses it.
  Matrix3d pose_ellipsoid{Matrix3d::Zero()};
  double pose_age_uncertainty{0.0};  ///< m: the share of pose_uncertainty that the age of the pose adds
  long rejected_poses{0};       ///< poses that were not finite or not a rotation; the last valid one was kept
  double t{0.0};                ///< s, of X_WB
  Twist velocity;               ///< from the last two poses; linear velocity of the centre of mass
  Twist mean_velocity;          ///< over the last Scene::kMeanSamples poses
  double max_speed{kInfinity};  ///< m/s, declared bound on the speed of its farthest point; checked by
                                ///< setPose
  /// Incremented when conclusions from times and speeds become invalid: max_speed exceeded or changed, or the
  /// object moved at the same or an earlier time.
  long interruptions{0};
  SpeedWatch::State speed_state;
  Wrench contact;  ///< sum over its pairs, about its centre of mass
  int contacts{0};
  bool colliding{false};  ///< a pair of it has a contact (margins included)
  Vector3d p_WCom() const { return X_WB * spec.structure->com; }
};

}  // namespace abstand::scene
