// Kinematics and dynamics of robots, a call at a time. Compare figures of one run with each other only.
#include <benchmark/benchmark.h>

#include "core/mechanism/effective_mass.hpp"
#include "core/mechanism/forward_dynamics.hpp"
#include "core/physics/physics_world.hpp"
#include "tests/support/robots.hpp"

namespace abstand::testing {
namespace {

const Mechanism& robot(const benchmark::State& state) {
  static const Mechanism seven = sevenAxisArm(), whole = humanoid();
  return state.range(0) == 7 ? seven : whole;
}

/// A robot in one of 64 postures, with everything that the calls below need.
struct Posture {
  RigidTree tree;
  std::vector<std::vector<double>> q;
  std::vector<double> qd, qdd, out;
  ForwardState state;
  std::size_t i{0};
  explicit Posture(const Mechanism& m) : tree(makeRigidTree(m)) {
    for (std::uint64_t seed = 0; seed < 64; ++seed) q.push_back(randomValues(m.dof, seed, 0, 2.0));
    qd = randomValues(m.dof, 1, 100, 2.0);
    qdd = randomValues(m.dof, 1, 200, 2.0);
    out.resize(q[0].size());
  }
  const std::vector<double>& next() { return q[i++ % q.size()]; }
};

void forwardKinematics(benchmark::State& state) {
  Posture p(robot(state));
  MechanismState poses;
  for (auto _ : state) {
    forward(robot(state), p.next(), poses);
    benchmark::DoNotOptimize(poses.X_BF.data());
  }
}
BENCHMARK(forwardKinematics)->Arg(7)->Arg(47);

void inverseDynamicsCall(benchmark::State& state) {
  Posture p(robot(state));
  for (auto _ : state) {
    inverseDynamics(p.tree, p.next(), p.qd, p.qdd, kGravity, {}, p.state.tree, p.out);
    benchmark::DoNotOptimize(p.out.data());
  }
}
BENCHMARK(inverseDynamicsCall)->Arg(7)->Arg(47);

void massMatrixCall(benchmark::State& state) {
  Posture p(robot(state));
  for (auto _ : state) {
    placeBodies(p.tree, p.next(), p.state.tree);
    massMatrix(p.tree, p.state.tree, p.state.mass);
    benchmark::DoNotOptimize(p.state.mass.M.data());
  }
}
BENCHMARK(massMatrixCall)->Arg(7)->Arg(47);

void forwardDynamicsCall(benchmark::State& state) {
  Posture p(robot(state));
  for (auto _ : state) {
    forwardDynamics(p.tree, p.next(), p.qd, p.qdd, kGravity, {}, p.state, p.out);
    benchmark::DoNotOptimize(p.out.data());
  }
}
BENCHMARK(forwardDynamicsCall)->Arg(7)->Arg(47);

void effectiveMassCall(benchmark::State& state) {
  Posture p(robot(state));
  forwardDynamics(p.tree, p.next(), p.qd, p.qdd, kGravity, {}, p.state, p.out);
  const int frame = static_cast<int>(p.tree.frames.size()) - 1;
  const Vector3d p_B = poseOfFrame(p.tree, p.state.tree, frame).translation();
  for (auto _ : state)
    benchmark::DoNotOptimize(
        effectiveMass(p.tree, p.state.tree, p.state.mass, frame, p_B, Vector3d::UnitX(), p.out));
}
BENCHMARK(effectiveMassCall)->Arg(7)->Arg(47);

/// One step of a world with `range(0)` dofs (14: two arms), solver `range(1)` (0: ODE's joints, 1: reduced).
void physicsStep(benchmark::State& state) {
  PhysicsWorld world;
  MechanismOptions options;
  options.solver = state.range(1) == 0 ? MechanismSolver::kJointed : MechanismSolver::kReduced;
  options.gravity_compensation = true;
  for (int i = 0; i < (state.range(0) == 14 ? 2 : 1); ++i) {
    const Mechanism m = state.range(0) == 47 ? humanoid() : sevenAxisArm();
    options.damping.assign(static_cast<std::size_t>(m.dof), 1.0);
    const int robot = world.addMechanism(m, Transform::Identity(), options);
    world.mechanism(robot).setState(randomValues(m.dof, 1, 0, 0.3),
                                    std::vector(static_cast<std::size_t>(m.dof), 0.0));
  }
  for (auto _ : state) world.step(0.001);
}
BENCHMARK(physicsStep)->ArgsProduct({{7, 14, 47}, {0, 1}})->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace abstand::testing
