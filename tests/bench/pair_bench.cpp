// Pair queries and kinematics, a call at a time. Compare figures of one run with each other only.
#include <benchmark/benchmark.h>

#include <chrono>

#include "core/query/pair_query.hpp"
#include "core/robot_file/mech_file.hpp"
#include "tests/support/random_pose.hpp"
#include "tests/support/structures.hpp"

namespace abstand::bench {
namespace {

/// An ellipsoid round a box at the given distance of centres (mm): touching, near, far.
void queryAt(benchmark::State& state) {
  const auto& a = testing::structureOf(geometry::Ellipsoid{{0.04, 0.05, 0.12}}, structure::FieldKind::kMixed);
  const auto& b = testing::structureOf(geometry::Cuboid{{0.1, 0.12, 0.3}}, structure::FieldKind::kMixed);
  std::vector<Transform> poses;
  for (std::uint64_t seed = 0; seed < 64; ++seed) {
    Transform X = testing::randomPose(seed, 0.0);
    X.translation() = testing::randomPose(seed + 100).translation().normalized() * 1e-3 *
                      static_cast<double>(state.range(0));
    poses.push_back(X);
  }
  kernels::PairScratch scratch;
  query::PairResult result;
  std::size_t i = 0;
  for (auto _ : state) {
    query::queryPair({a, poses[i++ % poses.size()]}, {b, Transform::Identity()}, {.margin = 0.02}, scratch,
                     result);
    benchmark::DoNotOptimize(result);
  }
}
BENCHMARK(queryAt)->Arg(120)->Arg(200)->Arg(500)->Arg(2000);

/// A box of 100 mm deep inside one of 400 mm: every shell point is a contact. `range`: spacing of points in
/// um.
void denseContact(benchmark::State& state) {
  const double spacing = 1e-6 * static_cast<double>(state.range(0));
  const auto inner =
      structure::buildHapticStructure("inner", geometry::makeSurface(geometry::Cuboid{{0.1, 0.1, 0.1}}),
                                      {.voxel_size = 0.005, .point_spacing = spacing});
  const auto& outer = testing::structureOf(geometry::Cuboid{{0.4, 0.4, 0.4}}, structure::FieldKind::kMixed);
  std::vector<Transform> poses;
  for (std::uint64_t seed = 0; seed < 16; ++seed) poses.push_back(testing::randomPose(seed, 0.05));
  kernels::PairScratch scratch;
  query::PairResult result;
  std::size_t i = 0;
  long points = 0;
  const auto begin = std::chrono::steady_clock::now();
  for (auto _ : state) {
    query::queryPair({*inner, poses[i++ % poses.size()]}, {outer, Transform::Identity()}, {}, scratch,
                     result);
    points += result.contacts;
  }
  const std::chrono::duration<double, std::nano> spent = std::chrono::steady_clock::now() - begin;
  state.counters["points"] = static_cast<double>(points) / static_cast<double>(i);
  state.counters["ns_per_point"] = spent.count() / static_cast<double>(points);
}
BENCHMARK(denseContact)->Arg(4000)->Arg(2000)->Unit(benchmark::kMicrosecond);

void forwardOfThreeLinks(benchmark::State& state) {
  const mechanism::Mechanism chain = robot_file::parseMechanism(
      "chain\nframe 1 0 0 0 theta\nframe 2 1.1 0 0 theta\nframe 3 1.1 0 0 theta\nend_chain\n", "chain");
  const std::vector<double> q{0.3, -0.2, 0.7};
  mechanism::MechanismState mechanism_state;
  for (auto _ : state) {
    mechanism::forward(chain, q, mechanism_state);
    benchmark::DoNotOptimize(mechanism_state.X_BF.data());
  }
}
BENCHMARK(forwardOfThreeLinks);

}  // namespace
}  // namespace abstand::bench
