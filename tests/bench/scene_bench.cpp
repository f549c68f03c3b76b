// Whole steps of scenes in lock step: 1,000 objects; two arms, a person and a table. Compare figures of one
// run with each other only.
#include <benchmark/benchmark.h>

#include <chrono>

#include "core/scene/cycle_statistics.hpp"
#include "core/scene/scene.hpp"
#include "tests/bench/bench_scene.hpp"
#include "tests/support/random_pose.hpp"
#include "tests/support/structures.hpp"

namespace abstand::bench {
namespace {

constexpr std::uint32_t kObjects = 1000;
constexpr double kHall = 10.0;  // m, half an edge of the cube that they lie in

/// Things of a hall, all pairs, most of them metres apart.
scene::Scene hall() {
  const std::shared_ptr<const structure::HapticStructure> kinds[] = {
      structure::buildHapticStructure("box", geometry::makeSurface(geometry::Cuboid{{0.1, 0.12, 0.3}}), {}),
      structure::buildHapticStructure("rod", geometry::makeSurface(geometry::Capsule{0.04, 0.4}), {}),
      structure::buildHapticStructure("ball", geometry::makeSurface(geometry::Sphere{0.1}), {})};
  scene::Scene scene;
  for (std::uint32_t i = 0; i < kObjects; ++i)
    scene.addObject({"object" + std::to_string(i), "objects", kinds[i % 3], 0.05});
  for (std::uint32_t i = 0; i < kObjects; ++i) scene.setPose(ObjectId(i), testing::randomPose(i, kHall), 0.0);
  for (std::uint32_t a = 0; a < kObjects; ++a)
    for (std::uint32_t b = a + 1; b < kObjects; ++b) scene.addPair(ObjectId(a), ObjectId(b));
  return scene;
}

/// `moving` objects, spread over the scene, go on circles at 1 m/s; a step a millisecond.
void stepOfAThousand(benchmark::State& state, const scene::QueryCulling& culling, int moving, int threads) {
  static scene::Scene scene = hall();
  scene.setThreads(threads);
  scene.setCulling(culling);
  scene.step();
  long n = 0;
  scene::StepCounts sum;
  for (auto _ : state) {
    const double t = 0.001 * static_cast<double>(++n);
    for (int k = 0; k < moving; ++k) {
      const auto i = static_cast<std::uint32_t>(k) * kObjects / static_cast<std::uint32_t>(moving);
      Transform X = testing::randomPose(i, kHall);
      X.translation() += Vector3d(std::cos(t), std::sin(t), 0.0);
      X.linear() = X.linear() * Eigen::AngleAxisd(t, Vector3d::UnitX());
      scene.setPose(ObjectId(i), X, t);
    }
    scene.step();
    sum.checked += scene.counts().checked;
    sum.rested += scene.counts().rested;
    sum.beyond += scene.counts().beyond;
    sum.deferred += scene.counts().deferred;
  }
  const auto perStep = [&](long count) { return static_cast<double>(count) / static_cast<double>(n); };
  state.counters["checked"] = perStep(sum.checked);
  state.counters["rested"] = perStep(sum.rested);
  state.counters["beyond"] = perStep(sum.beyond);
  state.counters["put_off"] = perStep(sum.deferred);
}

#define ABSTAND_STEP(name, culling, moving, threads) \
  BENCHMARK_CAPTURE(stepOfAThousand, name, culling, moving, threads)->Unit(benchmark::kMicrosecond)

ABSTAND_STEP(nothing_moves, scene::QueryCulling{}, 0, 1);
ABSTAND_STEP(ten_move_all_queried, scene::QueryCulling{}, 10, 1);
ABSTAND_STEP(ten_move_rest, scene::QueryCulling{.rest = 0.01}, 10, 1);
ABSTAND_STEP(ten_move_horizon, (scene::QueryCulling{.horizon = 2.0}), 10, 1);
ABSTAND_STEP(ten_move_both, (scene::QueryCulling{.rest = 0.01, .horizon = 2.0}), 10, 1);
ABSTAND_STEP(ten_move_half_a_millisecond, scene::QueryCulling{.budget = 0.0005}, 10, 1);
ABSTAND_STEP(ten_move_both_two_threads, (scene::QueryCulling{.rest = 0.01, .horizon = 2.0}), 10, 2);
ABSTAND_STEP(hundred_move_both, (scene::QueryCulling{.rest = 0.01, .horizon = 2.0}), 100, 1);

/// Structures of the arms, the person and the things, built once.
scene::Scene sceneOfArmsPersonTable() {
  static const auto structures = [] {
    std::vector<std::shared_ptr<const structure::HapticStructure>> built;
    const BenchScene& from = armsPersonTable();
    for (const auto& body : from.bodies) {
      const std::shared_ptr<const geometry::Surface> surface = geometry::makeSurface(body.mesh);
      built.push_back(structure::buildHapticStructure(body.name, surface, from.options));
    }
    return built;
  }();
  const BenchScene& from = armsPersonTable();
  scene::Scene scene;
  for (std::size_t i = 0; i < from.bodies.size(); ++i)
    scene.addObject({from.bodies[i].name, "bodies", structures[i], 0.0});
  for (const auto& [a, b] : from.pairs)
    scene.addPair(ObjectId(static_cast<std::uint32_t>(a)), ObjectId(static_cast<std::uint32_t>(b)));
  return scene;
}

/// A step a frame of the capture, which lasts 10 ms.
void stepOfArmsPersonTable(benchmark::State& state, const scene::QueryCulling& culling) {
  constexpr double kFrame = 0.01;  // s
  const BenchScene* from = nullptr;
  try {
    from = &armsPersonTable();
  } catch (const std::exception& e) {
    state.SkipWithError(e.what());
    return;
  }
  scene::Scene scene = sceneOfArmsPersonTable();
  scene.setCulling(culling);
  scene::CycleStatistics times(kInfinity);
  scene::StepCounts sum;
  while (state.KeepRunningBatch(static_cast<benchmark::IterationCount>(from->frames()))) {
    for (std::size_t f = 0; f < from->frames(); ++f) {
      const auto begin = std::chrono::steady_clock::now();
      for (std::uint32_t i = 0; i < scene.objectCount(); ++i)
        scene.setPose(ObjectId(i), from->frame(f)[i], kFrame * static_cast<double>(f));
      scene.step();
      times.add(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
      sum.checked += scene.counts().checked;
      sum.rested += scene.counts().rested;
      sum.beyond += scene.counts().beyond;
    }
  }
  const auto steps = static_cast<double>(times.count());
  state.counters["median_us"] = 1e6 * times.median();
  state.counters["p99_us"] = 1e6 * times.p99();
  state.counters["checked"] = static_cast<double>(sum.checked) / steps;
  state.counters["rested"] = static_cast<double>(sum.rested) / steps;
  state.counters["beyond"] = static_cast<double>(sum.beyond) / steps;
}

#define ABSTAND_ARMS(name, culling) \
  BENCHMARK_CAPTURE(stepOfArmsPersonTable, name, culling)->Iterations(1)->Unit(benchmark::kMicrosecond)

ABSTAND_ARMS(all_queried, scene::QueryCulling{});
ABSTAND_ARMS(remember, scene::QueryCulling{.remember = true});
ABSTAND_ARMS(remember_rest, (scene::QueryCulling{.rest = 0.01, .remember = true}));
ABSTAND_ARMS(remember_rest_longest, (scene::QueryCulling{.rest = 1.0, .remember = true}));
ABSTAND_ARMS(contacts_only, (scene::QueryCulling{.horizon = 0.0}));

}  // namespace
}  // namespace abstand::bench
