// One cycle of a reaction, and the swept distance of a braking arm. Compare figures of one run with each
// other only.
#include <benchmark/benchmark.h>

#include "core/control/reaction.hpp"
#include "core/math/random.hpp"
#include "core/robot_file/mech_file.hpp"
#include "core/safety/link_motion.hpp"
#include "core/safety/swept_pair.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/structures.hpp"

namespace abstand::bench {
namespace {

/// All laws but the proxy, 280 pairs, of which four are within the range of the potential.
void reactionCycle(benchmark::State& state) {
  const int dof = static_cast<int>(state.range(0));
  const auto n = static_cast<std::size_t>(dof);
  control::ReactionDescription d;
  d.torque = control::TorqueLimitOptions{.limit = {50.0}};
  d.repulsion = control::RepulsionOptions{};
  d.admittance = control::AdmittanceOptions{};
  d.speed = control::SpeedScaleOptions{};
  control::Reaction reaction(d, dof, 280);
  Random random(1, 1);
  std::vector<double> rows(280 * n), qd(n, 0.1), planned(n, 0.3), efforts(n, 1.0);
  for (double& x : rows) x = random.between(-1, 1);
  std::vector<control::ReactionPair> pairs;
  for (int i = 0; i < 280; ++i)
    pairs.push_back({.pair = i,
                     .distance = 0.06 + 0.01 * i,
                     .row = {rows.data() + static_cast<std::size_t>(i) * n, n},
                     .other_rate = -0.5,
                     .person = i % 2 == 0});
  const Eigen::MatrixXd M = Eigen::MatrixXd::Identity(dof, dof);
  control::ReactionInput in;
  in.dt = 1e-3;
  in.qd = qd;
  in.planned = planned;
  in.efforts = efforts;
  in.pairs = pairs;
  for (auto _ : state) {
    in.t += in.dt;
    benchmark::DoNotOptimize(reaction.update(in, M).speed_scale);
  }
}
BENCHMARK(reactionCycle)->Arg(7)->Arg(14)->Arg(47);

/// Does an arm that brakes stay clear of a hand that may do anything within its bounds?
void sweptBrakingArm(benchmark::State& state) {
  const structure::HapticStructure& rod =
      testing::structureOf(geometry::Capsule{0.05, 0.3}, structure::FieldKind::kMixed);
  const structure::HapticStructure& hand =
      testing::structureOf(geometry::Ellipsoid{{0.04, 0.05, 0.1}}, structure::FieldKind::kMixed);
  const mechanism::Mechanism arm =
      robot_file::loadMechanism(testing::projectFile("data/robots/lwr/lwr4.mech"));
  safety::BrakingPath path({.deceleration = {5.0}, .reaction_time = 0.02}, 7);
  const std::vector<double> q{0.3, 0.6, 0.0, 1.2, 0.0, 0.5, 0.0}, qd(7, 1.0);
  path.start(q, qd);
  safety::LinkMotion link(arm, path, 6, Transform::Identity(), Transform::Identity(), rod.bounding_sphere);
  const Vector3d end = link.pose(path.stopTime()).translation();
  std::vector<Transform> hands;
  for (std::uint64_t i = 0; i < 64; ++i) {
    Random random(5, i);
    hands.emplace_back(Eigen::Translation3d(end + random.between(0.4, 1.2) * random.direction()));
  }
  safety::SweptScratch scratch;
  std::size_t i = 0;
  long samples = 0;
  for (auto _ : state) {
    path.start(q, qd);
    safety::UnknownMotion unknown(hands[i++ % hands.size()], Vector3d::Zero(), {1.6, 20.0}, path.stopTime());
    samples += safety::sweptPair({rod, link}, {hand, unknown}, path.stopTime(),
                                 {.tolerance = 0.005, .enough = 0.0, .hit = 0.0}, scratch)
                   .samples;
  }
  state.counters["queries"] = static_cast<double>(samples) / static_cast<double>(state.iterations());
}
BENCHMARK(sweptBrakingArm);

}  // namespace
}  // namespace abstand::bench
