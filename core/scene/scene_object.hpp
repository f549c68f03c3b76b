// A body in the scene.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "core/math/transform.hpp"
#include "core/query/pair_query.hpp"
#include "core/scene/speed_watch.hpp"

namespace abstand::scene {

/// What is needed to put a body into the scene.
struct ObjectSpec {
  std::string name;   ///< unique in the scene
  std::string group;  ///< a mechanism's, a human's name, or "objects"
  std::shared_ptr<const structure::HapticStructure> structure;
  double margin{0.0};  ///< m, safety margin
};

/// How trustworthy an object's pose is; everything but kFresh is shown and never counts as safe.
enum class PoseState : std::uint8_t { kFresh, kInferred, kStale, kRejected };

/// One body in the scene, with its recent motion and what acts on it. World frame.
struct Object {
  ObjectSpec spec;
  Transform X_WB{Transform::Identity()};
  PoseState pose_state{PoseState::kFresh};
  /// m: every point of the body is within so much of where X_WB puts it; it widens the margins by which the
  /// body's distances are judged. Infinite: it may be anywhere.
  double pose_uncertainty{0.0};
  long rejected_poses{0};       ///< poses that were not finite or no rotation; the last good one stayed
  double t{0.0};                ///< s, of X_WB
  Twist velocity;               ///< instant: from the last two poses; linear of the centre of mass
  Twist mean_velocity;          ///< over the last Scene::kMeanSamples poses
  double max_speed{kInfinity};  ///< m/s, of its farthest point; what rests on it is watched by setPose
  /// Grows when what was concluded from times and speeds no longer holds: at a breach of max_speed, when
  /// max_speed changes, and when the object is moved back in time or without time.
  long interruptions{0};
  SpeedWatch::State speed_state;
  Wrench contact;  ///< sum over its pairs, about its centre of mass
  int contacts{0};
  bool colliding{false};  ///< some pair of it has a contact (margins included)
  Vector3d p_WCom() const { return X_WB * spec.structure->com; }
};

}  // namespace abstand::scene
