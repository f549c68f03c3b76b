#include "core/mechanism/motion_limits.hpp"

#include <algorithm>
#include <cmath>

#include "core/mechanism/inverse_dynamics.hpp"
#include "core/mechanism/smooth_motion.hpp"

namespace abstand::mechanism {
namespace {

/// Calls visit(t0, t1) for the intervals between rows, clipped to [start, end].
template <class Visit>
void forEachInterval(const MotionTable& motion, double start, double end, Visit visit) {
  const std::span<const double> t = motion.times();
  for (std::size_t i = 1; i < t.size(); ++i) {
    const double t0 = std::max(t[i - 1], start), t1 = std::min(t[i], end);
    if (t0 < t1) visit(t0, t1);
  }
}

void checkLinear(const MotionTable& motion, double start, double end, JointLimitWatch& watch) {
  const auto n = static_cast<std::size_t>(motion.dof());
  std::vector<double> q0(n), q1(n), qd(n);
  motion.at(start, q0);
  watch.check(start, q0, {}, {}, {});
  forEachInterval(motion, start, end, [&](double t0, double t1) {
    motion.at(t0, q0);
    motion.at(t1, q1);
    for (std::size_t k = 0; k < n; ++k) qd[k] = (q1[k] - q0[k]) / (t1 - t0);
    watch.check(t0, q0, qd, {}, {});
    watch.check(t1, q1, {}, {}, {});
  });
}

void checkSmooth(const Mechanism& mechanism, const MotionTable& table, double start, double end,
                 const Vector3d& gravity_B, JointLimitWatch& watch) {
  const SmoothMotion motion(table);
  const RigidTree tree = makeRigidTree(mechanism);
  const bool weighed = std::any_of(tree.bodies.begin(), tree.bodies.end(),
                                   [](const TreeBody& body) { return body.mass > 0.0; });
  const auto n = static_cast<std::size_t>(table.dof());
  std::vector<double> q(n), qd(n), qdd(n), efforts(n);
  TreeState state;
  const auto checkAt = [&](double t) {
    motion.at(t, q, qd, qdd);
    if (weighed) inverseDynamics(tree, {q, qd, qdd}, {gravity_B, {}}, state, efforts);
    watch.check(t, q, qd, qdd, weighed ? std::span<const double>(efforts) : std::span<const double>());
  };
  checkAt(start);
  forEachInterval(table, start, end, [&](double t0, double t1) {
    // At its end points the motion is at rest; just inside it has its first and last accelerations.
    const double inside0 = std::nextafter(t0, t1), inside1 = std::nextafter(t1, t0);
    for (int i = 0; i <= kSmoothSamples; ++i)
      checkAt(std::clamp(t0 + (t1 - t0) * i / kSmoothSamples, inside0, std::max(inside0, inside1)));
  });
}

}  // namespace

std::vector<LimitBreach> motionBreaches(const Mechanism& mechanism, const MotionTable& motion,
                                        MotionLine line, double start, double end,
                                        const Vector3d& gravity_B) {
  JointLimitWatch watch(dofLimits(mechanism));
  if (line == MotionLine::kLinear)
    checkLinear(motion, start, end, watch);
  else
    checkSmooth(mechanism, motion, start, end, gravity_B, watch);
  return watch.breaches();
}

}  // namespace abstand::mechanism
