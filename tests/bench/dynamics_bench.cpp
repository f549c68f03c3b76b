// Kinematics and dynamics of robots, a call at a time. Compare figures of one run with each other only.
#include <benchmark/benchmark.h>

#include "core/mechanism/effective_mass.hpp"
#include "core/mechanism/forward_dynamics.hpp"
#include "core/physics/physics_world.hpp"
#include "tests/support/robots.hpp"

namespace abstand::bench {
namespace {

const mechanism::Mechanism& robot(const benchmark::State& state) {
  static const mechanism::Mechanism seven = testing::sevenAxisArm(), whole = testing::humanoid();
  return state.range(0) == 7 ? seven : whole;
}

/// A robot in one of 64 postures, with everything that the calls below need.
struct Posture {
  mechanism::RigidTree tree;
  std::vector<std::vector<double>> q;
  std::vector<double> qd, qdd, out;
  mechanism::ForwardState state;
  std::size_t i{0};
  explicit Posture(const mechanism::Mechanism& m) : tree(mechanism::makeRigidTree(m)) {
    for (std::uint64_t seed = 0; seed < 64; ++seed) q.push_back(testing::randomValues(m.dof, seed, 0, 2.0));
    qd = testing::randomValues(m.dof, 1, 100, 2.0);
    qdd = testing::randomValues(m.dof, 1, 200, 2.0);
    out.resize(q[0].size());
  }
  const std::vector<double>& next() { return q[i++ % q.size()]; }
};

void forwardKinematics(benchmark::State& state) {
  Posture p(robot(state));
  mechanism::MechanismState poses;
  for (auto _ : state) {
    mechanism::forward(robot(state), p.next(), poses);
    benchmark::DoNotOptimize(poses.X_BF.data());
  }
}
BENCHMARK(forwardKinematics)->Arg(7)->Arg(47);

void inverseDynamicsCall(benchmark::State& state) {
  Posture p(robot(state));
  for (auto _ : state) {
    mechanism::inverseDynamics(p.tree, {p.next(), p.qd, p.qdd}, {mechanism::kGravity, {}}, p.state.tree,
                               p.out);
    benchmark::DoNotOptimize(p.out.data());
  }
}
BENCHMARK(inverseDynamicsCall)->Arg(7)->Arg(47);

void massMatrixCall(benchmark::State& state) {
  Posture p(robot(state));
  for (auto _ : state) {
    mechanism::placeBodies(p.tree, p.next(), p.state.tree);
    mechanism::massMatrix(p.tree, p.state.tree, p.state.mass);
    benchmark::DoNotOptimize(p.state.mass.M.data());
  }
}
BENCHMARK(massMatrixCall)->Arg(7)->Arg(47);

void forwardDynamicsCall(benchmark::State& state) {
  Posture p(robot(state));
  for (auto _ : state) {
    mechanism::forwardDynamics(p.tree, {p.next(), p.qd, {}}, p.qdd, {mechanism::kGravity, {}}, p.state,
                               p.out);
    benchmark::DoNotOptimize(p.out.data());
  }
}
BENCHMARK(forwardDynamicsCall)->Arg(7)->Arg(47);

void effectiveMassCall(benchmark::State& state) {
  Posture p(robot(state));
  mechanism::forwardDynamics(p.tree, {p.next(), p.qd, {}}, p.qdd, {mechanism::kGravity, {}}, p.state, p.out);
  const int frame = static_cast<int>(p.tree.frames.size()) - 1;
  const Vector3d p_B = mechanism::poseOfFrame(p.tree, p.state.tree, frame).translation();
  for (auto _ : state)
    benchmark::DoNotOptimize(
        mechanism::effectiveMass({p.tree, p.state.tree, p.state.mass}, frame, p_B, Vector3d::UnitX(), p.out));
}
BENCHMARK(effectiveMassCall)->Arg(7)->Arg(47);

/// One step of a world with `range(0)` dofs (14: two arms), solver `range(1)` (0: ODE's joints, 1: reduced).
void physicsStep(benchmark::State& state) {
  physics::PhysicsWorld world;
  physics::MechanismOptions options;
  options.solver =
      state.range(1) == 0 ? physics::MechanismSolver::kJointed : physics::MechanismSolver::kReduced;
  options.gravity_compensation = true;
  for (int i = 0; i < (state.range(0) == 14 ? 2 : 1); ++i) {
    const mechanism::Mechanism m = state.range(0) == 47 ? testing::humanoid() : testing::sevenAxisArm();
    options.damping.assign(static_cast<std::size_t>(m.dof), 1.0);
    const int robot = world.addMechanism(m, Transform::Identity(), options);
    world.mechanism(robot).setState(testing::randomValues(m.dof, 1, 0, 0.3),
                                    std::vector(static_cast<std::size_t>(m.dof), 0.0));
  }
  for (auto _ : state) world.step(0.001);
}
BENCHMARK(physicsStep)->ArgsProduct({{7, 14, 47}, {0, 1}})->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace abstand::bench
