// Check of Newton's third law.
#include "core/verify/third_law.hpp"

#include "core/base/parallel.hpp"
#include "core/verify/adversarial_poses.hpp"
#include "core/verify/check_tools.hpp"

namespace abstand::verify {
namespace {

constexpr double kLimit = 1e-12;     // of the moments: rounding in double
constexpr double kPoseReach = 10.0;  // m, range of the points about which moments are taken
constexpr double kMaxMargin = 0.05;  // m
// Share 1 / kHullPart of options.poses: the brute force gets the most.
constexpr std::size_t kHullPart = 5;

/// Both results are NaN for a pose without contact.
struct Sums {
  double moment{kNaN};
  double exchange{kNaN};
};

Sums sums(const AdversarialBody& a, const AdversarialBody& b, const AdversarialPose& pose, Random& random) {
  Sums s;
  const std::size_t field = random.below(kFields.size());
  const structure::HapticStructure &A = *a.structures[field], &B = *b.structures[field];
  const query::PairOptions options{
      .margin = random.chance(0.5) ? 0.0 : random.between(0.0, kMaxMargin),
      .stiffness = 1e6,
      .law = random.chance(0.5) ? query::ForceLaw::kVolume : query::ForceLaw::kThesis};
  const query::PairResult r = query(A, pose.X_WA, B, pose.X_WB, options);
  if (r.contacts == 0) return s;
  const Vector3d q = random.inCube(kPoseReach);
  const Vector3d arm_a = pose.X_WA * A.com - q, arm_b = pose.X_WB * B.com - q;
  const Vector3d on_a = r.torque_a + arm_a.cross(r.force_a), on_b = r.torque_b - arm_b.cross(r.force_a);
  const double size =
      r.torque_a.norm() + r.torque_b.norm() + (arm_a.norm() + arm_b.norm()) * r.force_a.norm();
  s.moment = size > 0.0 ? (on_a + on_b).norm() / size : 0.0;
  if (a.radius == b.radius) return s;
  const query::PairResult back = query(B, pose.X_WB, A, pose.X_WA, options);
  const bool same = back.force_a == -r.force_a && back.torque_a == r.torque_b &&
                    back.torque_b == r.torque_a && back.distance == r.distance && back.bound == r.bound &&
                    back.contacts == r.contacts && back.witness_a == r.witness_b &&
                    back.witness_b == r.witness_a;
  s.exchange = same ? 0.0 : 1.0;
  return s;
}

}  // namespace

std::vector<CheckResult> checkThirdLaw(const VerifyOptions& options) {
  const std::vector<AdversarialBody> bodies = adversarialBodies(options.threads);
  const std::size_t poses = std::max<std::size_t>(options.poses / kHullPart, 1);
  std::vector<Sums> all(poses);
  parallelFor(options.threads, poses, [&](std::size_t i) {
    if (options.stop()) return;
    const AdversarialPose pose = adversarialPose(bodies, options.seed, i);
    Random random(options.seed + 1, i);
    all[i] = sums(bodies[pose.a], bodies[pose.b], pose, random);
  });
  std::vector<double> moments, exchanges;
  for (const Sums& s : all) {
    if (!std::isnan(s.moment)) moments.push_back(s.moment);
    if (!std::isnan(s.exchange)) exchanges.push_back(s.exchange);
  }

  CheckResult law;
  law.name = "third_law";
  law.what =
      "Pairs in contact, with and without margins, all fields and both force laws: the moments of both "
      "bodies' forces and torques about any point within 10 m add up to zero.";
  law.quantity = "|sum of the moments| / sum of their sizes";
  law.reason = "Rounding in double; the kilometre of some poses costs four digits of sixteen.";
  judge(law, moments, kLimit);

  CheckResult exchange;
  exchange.name = "exchange";
  exchange.what =
      "Asking for B and A instead of A and B gives the opposite force, each body's own torque, and the "
      "same distance, bound and nearest points, to the last bit.";
  exchange.quantity = "1 where a bit differs";
  exchange.reason = "Which body gives the points depends on the bodies alone.";
  judge(exchange, exchanges, 0.0);
  if (options.stop()) law.passed = exchange.passed = false;
  return {law, exchange};
}

}  // namespace abstand::verify
