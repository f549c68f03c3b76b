#include "core/safety/swept_pair.hpp"

namespace abstand::safety {

SweptResult sweptPair(const MovingBody& a, const MovingBody& b, double duration, const SweptOptions& options,
                      SweptScratch& s) noexcept {
  return sweptDistance(
      duration,
      [&](double t) {
        query::queryPair({a.body, a.motion.pose(t)}, {b.body, b.motion.pose(t)}, {}, {s.memory, s.scratch},
                         s.result);
        const double slack = a.motion.slack(t) + b.motion.slack(t);
        return DistanceSample{s.result.distance - s.result.bound - slack, s.result.distance - slack};
      },
      [&](double t0, double t1) { return a.motion.speed(t0, t1) + b.motion.speed(t0, t1); }, options);
}

}  // namespace abstand::safety
