// A small closed loop: a fist comes at an arm that yields, or does not.
#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "core/control/pair_direction.hpp"
#include "core/control/reaction.hpp"
#include "core/mesh_file/mesh_file.hpp"
#include "core/robot_file/mech_file.hpp"
#include "tests/support/paths.hpp"

namespace abstand::control {
namespace closed_loop_test {

constexpr double kDt = 1e-3;
constexpr int kSteps = 4000;

/// The arm's outer links and a ball for a fist; built once.
struct Bodies {
  mechanism::Mechanism arm = robot_file::loadMechanism(testing::projectFile("data/robots/lwr/lwr4.mech"));
  std::vector<int> frames{3, 4, 5, 6};  ///< indices: links 4 to 7
  std::vector<std::shared_ptr<const structure::HapticStructure>> links;
  std::shared_ptr<const structure::HapticStructure> fist;
  Bodies() {
    const structure::HapticOptions coarse{.voxel_size = 0.01, .point_spacing = 0.01, .outer_layers = 10};
    for (const int f : frames) {
      const std::string name = "link" + std::to_string(f + 1);
      links.push_back(structure::buildHapticStructure(
          name,
          geometry::makeSurface(
              mesh_file::loadMesh(testing::projectFile("data/robots/lwr/" + name + ".stl")).mesh),
          coarse, 2));
    }
    fist = structure::buildHapticStructure("fist", geometry::makeSurface(geometry::Sphere{0.06}), coarse, 2);
  }
};
const Bodies& bodies() {
  static const Bodies all;
  return all;
}

struct Outcome {
  double nearest{kInfinity};   ///< m, over the run
  double farthest_joint{0.0};  ///< rad, from where it was
  double rest{0.0};            ///< rad, the same at the end
  safety::StopState state{safety::StopState::kRunning};
};

/// Joints are double integrators of the constant inertias below, held softly at q_0 by springs and dampers.
/// The fist comes at `speed` to where a point of the arm was, stays a moment and goes back.
Outcome punch(const ReactionDescription& description, double speed) {
  const Bodies& b = bodies();
  const std::vector<double> inertia{1.5, 1.5, 0.8, 0.8, 0.2, 0.2, 0.1};
  const std::vector<double> q_0{0.3, 0.6, 0.0, 1.2, 0.0, 0.5, 0.0};
  Eigen::MatrixXd M = Eigen::MatrixXd::Zero(7, 7);
  for (int i = 0; i < 7; ++i) M(i, i) = inertia[i];

  Reaction reaction(description, 7, b.frames.size());
  std::vector<double> q = q_0, qd(7, 0.0), planned(7, 0.0);
  mechanism::MechanismState state;
  std::vector<std::vector<double>> rows(b.frames.size(), std::vector<double>(7));
  std::vector<query::PairMemory> memories(b.frames.size());
  std::vector<ReactionPair> pairs(b.frames.size());
  auto scratch = std::make_unique<kernels::PairScratch>();
  query::PairResult result;

  mechanism::forward(b.arm, q, state);
  const Vector3d goal = state.X_BF[4] * Vector3d(0, 0, -0.1);
  const Vector3d from = goal + Vector3d(0.5, 0.6, 0.1);
  const double duration = (goal - from).norm() / speed;
  Outcome outcome;
  for (int step = 0; step < kSteps; ++step) {
    const double t = step * kDt;
    const double s =
        t < duration ? t / duration : std::max(0.0, 1.0 - std::max(0.0, t - duration - 0.2) / duration);
    const Vector3d v = t < duration                                   ? Vector3d((goal - from) / duration)
                       : t < duration + 0.2 || t > 2 * duration + 0.2 ? Vector3d(Vector3d::Zero())
                                                                      : Vector3d((from - goal) / duration);
    const Transform X_WFist(Eigen::Translation3d(from + s * (goal - from)));

    mechanism::forward(b.arm, q, state);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const int frame = b.frames[i];
      query::queryPair({*b.links[i], state.X_BF[static_cast<std::size_t>(frame)]}, {*b.fist, X_WFist}, {},
                       {memories[i], *scratch}, result);
      outcome.nearest = std::min(outcome.nearest, result.distance);
      const Vector3d n = partingDirection(result);
      std::fill(rows[i].begin(), rows[i].end(), 0.0);
      addDistanceRow(b.arm, state, {frame, result.witness_a, n}, 1.0, rows[i]);
      pairs[i] = {.pair = static_cast<int>(i),
                  .distance = result.distance - result.bound,
                  .row = rows[i],
                  .other_rate = -n.dot(v),
                  .person = true};
    }
    ReactionInput in;
    in.t = t;
    in.dt = kDt;
    in.qd = qd;
    in.planned = planned;
    in.pairs = pairs;
    const ReactionOutput out = reaction.update(in, M);
    outcome.state = out.state;
    outcome.rest = 0.0;
    for (int i = 0; i < 7; ++i) {
      const double hold = 4.0 * inertia[i] * (q_0[i] - q[i]) - 4.0 * inertia[i] * qd[i];
      qd[i] += kDt * (hold + out.torque[i]) / inertia[i];
      q[i] += kDt * qd[i];
      outcome.farthest_joint = std::max(outcome.farthest_joint, std::abs(q[i] - q_0[i]));
      outcome.rest = std::max(outcome.rest, std::abs(q[i] - q_0[i]));
    }
  }
  return outcome;
}

TEST(ClosedLoop, FistHitsWithoutAvoidance) {
  const Outcome o = punch({}, 1.0);
  EXPECT_LT(o.nearest, -0.02);
  EXPECT_EQ(o.farthest_joint, 0.0);
}

TEST(ClosedLoop, ArmYieldsAndReturnsWithAvoidance) {
  ReactionDescription d;
  d.repulsion = RepulsionOptions{.range = 0.15, .force = 150.0, .damping = 0.7};
  d.torque = TorqueLimitOptions{.limit = {120.0, 120.0, 60.0, 60.0, 30.0, 30.0, 20.0}};
  const Outcome o = punch(d, 1.0);
  EXPECT_GT(o.nearest, 0.01);
  EXPECT_GT(o.farthest_joint, 0.1);
  EXPECT_LT(o.rest, 0.1 * o.farthest_joint) << "it is back when the fist is gone";
  EXPECT_EQ(o.state, safety::StopState::kRunning);
}

TEST(ClosedLoop, IsDeterministic) {
  ReactionDescription d;
  d.repulsion = RepulsionOptions{.range = 0.15, .force = 150.0};
  EXPECT_EQ(punch(d, 1.0).nearest, punch(d, 1.0).nearest);
}

TEST(ClosedLoop, HigherSpeedAndLowerLimitReduceClearance) {
  ReactionDescription d;
  d.repulsion = RepulsionOptions{.range = 0.15, .force = 150.0};
  EXPECT_LT(punch(d, 2.0).nearest, punch(d, 1.0).nearest);
  d.torque = TorqueLimitOptions{.limit = {0.5}};
  EXPECT_LT(punch(d, 1.0).nearest, 0.0);
}

}  // namespace closed_loop_test
}  // namespace abstand::control
