// When a pair of live mode rests: by what its bodies are said to do at most.
#pragma once

#include "core/scene/temporal_culling.hpp"

namespace abstand::scene {

/// What live mode knows of an object beside its pose.
struct LiveObject {
  double t{-kInfinity};         ///< s, of its pose
  long interruptions{0};        ///< Object::interruptions
  double max_speed{kInfinity};  ///< m/s, Object::max_speed
};

/// A pair may rest while (v_A + v_B) times the time since its query is within a share of its clearance, v the
/// bound on the speed of each body's farthest point. Each body's time is that of its own poses. The scene
/// watches the bounds with every pose; a broken one ends the rest at that pose, so up to it the bodies have
/// kept what is relied on here.
class LiveCulling {
 public:
  /// A body of the pair at the query.
  struct Placed {
    const Transform& X_WB;
    const LiveObject& object;
  };
  void take(const query::PairResult& result, const Placed& a, const Placed& b, double touch_from,
            double margin, double share);
  /// Without a bound on both speeds, and with a new margin: never.
  bool mayRest(const LiveObject& a, const LiveObject& b, double margin) const;
  /// Only when it may rest.
  void carry(const Transform& X_WA, const Transform& X_WB, const LiveObject& a, const LiveObject& b,
             query::PairResult& result) const;

 private:
  double movement(const LiveObject& a, const LiveObject& b) const;

  PairProof proof_;
  LiveObject a_, b_;  ///< at the query
  double allowance_{-1.0};
  double margin_{0.0};
};

}  // namespace abstand::scene
