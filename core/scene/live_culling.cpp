#include "core/scene/live_culling.hpp"

#include "core/scene/speed_watch.hpp"

namespace abstand::scene {

void LiveCulling::update(const query::PairResult& result, const Placed& a, const Placed& b,
                         double contact_distance, double margin, double share) {
  proof_.update(result, a.X_WB, b.X_WB);
  a_ = a.object;
  b_ = b.object;
  allowance_ = allowanceOf(proof_, result, contact_distance, share);
  margin_ = margin;
}

double LiveCulling::movement(const LiveObject& a, const LiveObject& b) const {
  return (a.max_speed * (a.t - a_.t) + b.max_speed * (b.t - b_.t)) * SpeedWatch::kTolerance;
}

bool LiveCulling::mayCull(const LiveObject& a, const LiveObject& b, double margin) const {
  return margin == margin_ && a.interruptions == a_.interruptions && b.interruptions == b_.interruptions &&
         a.max_speed < kInfinity && b.max_speed < kInfinity && movement(a, b) <= allowance_;
}

void LiveCulling::carry(const Transform& X_WA, const Transform& X_WB, const LiveObject& a,
                        const LiveObject& b, query::PairResult& result) const {
  proof_.carry(X_WA, X_WB, proof_.lower - movement(a, b), result);
}

}  // namespace abstand::scene
