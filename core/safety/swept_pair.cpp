#include "core/safety/swept_pair.hpp"

namespace abstand::safety {

SweptResult sweptPair(const MovingBody& a, const MovingBody& b, double duration, const SweptOptions& options,
                      const SweptContext& c) noexcept {
  return sweptDistance(
      duration,
      [&](double t) {
        query::queryPair({a.body, a.motion.pose(t)}, {b.body, b.motion.pose(t)}, {}, {c.memory, c.scratch},
                         c.result);
        const double slack = a.motion.slack(t) + b.motion.slack(t);
        return DistanceSample{c.result.distance - c.result.bound - slack, c.result.distance - slack};
      },
      [&](double t0, double t1) { return a.motion.speed(t0, t1) + b.motion.speed(t0, t1); }, options, c.ends);
}

}  // namespace abstand::safety
