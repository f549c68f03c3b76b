// Building of structures, and opening of scenes from the cache, on all cores.
#include <benchmark/benchmark.h>
#include <cstdlib>

#include "app/session/session.hpp"
#include "core/base/data_folder.hpp"
#include "core/base/parallel.hpp"
#include "tests/bench/bench_scene.hpp"
#include "tests/support/bumpy_meshes.hpp"

namespace abstand::bench {
namespace {

void report(benchmark::State& state, std::size_t bytes, std::size_t points) {
  state.counters["MB"] = 1e-6 * static_cast<double>(bytes);
  state.counters["points"] = static_cast<double>(points);
}

/// All structures of a scene from their meshes, surfaces included, as a session without a cache builds them.
void build(benchmark::State& state, const BenchScene& (*make)(), std::size_t bodies) {
  const BenchScene& scene = make();
  bodies = std::min(bodies, scene.bodies.size());
  std::size_t bytes = 0, points = 0;
  for (auto _ : state) {
    std::vector<std::shared_ptr<const structure::HapticStructure>> built(bodies);
    parallelFor(0, bodies, [&](std::size_t i) {
      const std::shared_ptr<const geometry::Surface> surface = geometry::makeSurface(scene.bodies[i].mesh);
      built[i] =
          structure::buildHapticStructure(scene.bodies[i].name, surface, scene.options, bodies == 1 ? 0 : 1);
    });
    bytes = points = 0;
    for (const auto& s : built) {
      bytes += s->memoryBytes();
      points += s->shell.size();
    }
  }
  report(state, bytes, points);
}
BENCHMARK_CAPTURE(build, bumpy_ball_2mm, bunnyOnBunny, 1)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(build, arms_person_table_4mm, armsPersonTable, 1000)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void buildMesh(benchmark::State& state, const geometry::TriangleMesh& mesh, double voxel, double point) {
  std::size_t bytes = 0, points = 0;
  for (auto _ : state) {
    const std::shared_ptr<const geometry::Surface> surface = geometry::makeSurface(mesh);
    const auto s = structure::buildHapticStructure(
        "mesh", surface, {.voxel_size = voxel, .point_spacing = point, .outer_layers = 6});
    bytes = s->memoryBytes();
    points = s->shell.size();
  }
  report(state, bytes, points);
}

void buildOf300000Triangles(benchmark::State& state) {
  buildMesh(state, testing::bumpyTorus(0.3, 0.1, 500, 300), 0.005, 0.005);
}
BENCHMARK(buildOf300000Triangles)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);

void shellOfAMillionPoints(benchmark::State& state) {
  const auto surface = geometry::makeSurface(geometry::Shape{geometry::Sphere{0.5}});
  std::size_t points = 0;
  for (auto _ : state) points = shell::makePointshell(*surface, 0.00164, 0).size();
  state.counters["points"] = static_cast<double>(points);
}
BENCHMARK(shellOfAMillionPoints)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);

/// The boxing scene from a cache folder that has it all: reading files, looking up structures, pairs.
void openFromCache(benchmark::State& state) {
  const auto folder = std::filesystem::temp_directory_path() / "abstand_bench_cache";
  std::filesystem::remove_all(folder);
  setenv("ABSTAND_CACHE", folder.c_str(), 1);
  const auto file = dataFolder() / "scenes" / "hug_boxing.yaml";
  try {
    { const session::Session first(scene_file::loadScene(file), {}); }
    for (auto _ : state) {
      const session::Session session(scene_file::loadScene(file), {});
      benchmark::DoNotOptimize(session.cachedStructures());
      state.counters["structures_from_cache"] = static_cast<double>(session.cachedStructures());
    }
  } catch (const std::exception& e) {
    state.SkipWithError(e.what());
  }
  std::filesystem::remove_all(folder);
}
BENCHMARK(openFromCache)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace abstand::bench
