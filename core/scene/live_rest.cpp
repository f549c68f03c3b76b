#include "core/scene/live_rest.hpp"

#include "core/scene/speed_watch.hpp"

namespace abstand {

void LiveRest::take(const PairResult& result, const Transform& X_WA, const Transform& X_WB,
                    const LiveObject& a, const LiveObject& b, double touch_from, double margin,
                    double share) {
  proof_.take(result, X_WA, X_WB);
  a_ = a;
  b_ = b;
  allowance_ = allowanceOf(proof_, result, touch_from, share);
  margin_ = margin;
}

double LiveRest::movement(const LiveObject& a, const LiveObject& b, double speed_a, double speed_b) const {
  return (speed_a * (a.t - a_.t) + speed_b * (b.t - b_.t)) * SpeedWatch::kTolerance;
}

bool LiveRest::mayRest(const LiveObject& a, const LiveObject& b, double speed_a, double speed_b,
                       double margin) const {
  return margin == margin_ && a.interruptions == a_.interruptions && b.interruptions == b_.interruptions &&
         speed_a < kInfinity && speed_b < kInfinity && movement(a, b, speed_a, speed_b) <= allowance_;
}

void LiveRest::carry(const Transform& X_WA, const Transform& X_WB, const LiveObject& a, const LiveObject& b,
                     double speed_a, double speed_b, PairResult& result) const {
  proof_.carry(X_WA, X_WB, proof_.lower - movement(a, b, speed_a, speed_b), result);
}

}  // namespace abstand
