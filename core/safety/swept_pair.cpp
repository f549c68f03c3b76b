#include "core/safety/swept_pair.hpp"

namespace abstand::safety {

SweptResult sweptPair(const structure::HapticStructure& a, BodyMotion& motion_a,
                      const structure::HapticStructure& b, BodyMotion& motion_b, double duration,
                      const SweptOptions& options, SweptScratch& s) noexcept {
  return sweptDistance(
      duration,
      [&](double t) {
        query::queryPair({a, motion_a.pose(t)}, {b, motion_b.pose(t)}, {}, {s.memory, s.scratch}, s.result);
        const double slack = motion_a.slack(t) + motion_b.slack(t);
        return DistanceSample{s.result.distance - s.result.bound - slack, s.result.distance - slack};
      },
      [&](double t0, double t1) { return motion_a.speed(t0, t1) + motion_b.speed(t0, t1); }, options);
}

}  // namespace abstand::safety
