// Query culling in live mode, by declared speed bounds.
#pragma once

#include "core/scene/temporal_culling.hpp"

namespace abstand::scene {

/// What live mode knows of an object besides its pose.
struct LiveObject {
  double t{-kInfinity};         ///< s, time of its pose
  long interruptions{0};        ///< Object::interruptions
  double max_speed{kInfinity};  ///< m/s, Object::max_speed
};

/// A pair is not queried as long as (v_A + v_B) times the time since its query is within a share of its
/// clearance; v is the bound on the speed of each body's farthest point. Each body's time is that of its own
/// poses. The scene checks the bounds with every pose; a violation ends culling at that pose, so until then
/// the bounds hold.
class LiveCulling {
 public:
  /// Pose and state of a body of the pair at the query.
  struct Placed {
    const Transform& X_WB;
    const LiveObject& object;
  };
  void update(const query::PairResult& result, const Placed& a, const Placed& b, double contact_distance,
              double margin, double share);
  /// Whether the query may be skipped. Never without bounds on both speeds, nor after a change of the margin.
  bool mayCull(const LiveObject& a, const LiveObject& b, double margin) const;
  /// Carries the last result to new poses. Only if mayCull().
  void carry(const Transform& X_WA, const Transform& X_WB, const LiveObject& a, const LiveObject& b,
             query::PairResult& result) const;

 private:
  double movement(const LiveObject& a, const LiveObject& b) const;

  PairProof proof_;
  LiveObject a_, b_;  ///< at the time of the query
  double allowance_{-1.0};
  double margin_{0.0};
};

}  // namespace abstand::scene
