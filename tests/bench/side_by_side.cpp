#include "tests/bench/side_by_side.hpp"

#include <benchmark/benchmark.h>

#include <chrono>

#include "core/base/error.hpp"
#include "core/math/quantile.hpp"

namespace abstand::bench {
namespace {

constexpr std::size_t kMoreContacts = 10;  // than distances

using SceneMaker = const BenchScene& (*)();

struct Entry {
  const char* name;
  SceneMaker make;
  std::vector<Work> works;
};

const char* shortName(Work work) {
  switch (work) {
    case Work::kDistance:
      return "distance";
    case Work::kContact:
      return "contact";
    case Work::kCollide:
      return "collide";
    case Work::kSmallest:
      return "smallest";
  }
  return "";
}

/// One engine of a kind at a time: its work on a scene comes in a row, and all of them together are large.
Engine& engineFor(const BenchScene& scene, Kind kind) {
  struct Opened {
    const BenchScene* scene{nullptr};
    std::unique_ptr<Engine> engine;
  };
  static std::map<Kind, Opened> opened;
  Opened& now = opened[kind];
  if (now.scene != &scene) now = {&scene, open(kind, scene)};
  return *now.engine;
}

/// FCL needs many milliseconds for distances, and for the contacts of two large bodies.
std::size_t frameStep(const BenchScene& scene, Work work, Kind kind) {
  if (kind != Kind::kFcl) return 1;
  if (work == Work::kDistance || work == Work::kSmallest) return scene.sparse;
  return scene.pairs.size() > 1 ? 1 : std::max<std::size_t>(1, scene.sparse / kMoreContacts);
}

/// One pass over the frames of the scene; an iteration is a frame.
void sideBySide(benchmark::State& state, SceneMaker make, Work work, Kind kind) {
  using Clock = std::chrono::steady_clock;
  const BenchScene* scene = nullptr;
  try {
    scene = &make();
  } catch (const std::exception& e) {
    state.SkipWithError(e.what());
    return;
  }
  Engine& engine = engineFor(*scene, kind);
  const std::size_t step = frameStep(*scene, work, kind);
  const std::size_t count = (scene->frames() + step - 1) / step;
  std::vector<Answer> answers(work == Work::kSmallest ? 1 : scene->pairs.size());
  std::vector<double> us;
  while (state.KeepRunningBatch(static_cast<benchmark::IterationCount>(count))) {
    engine.frame(scene->frame(0), work, answers);  // not measured
    double sum = 0.0;
    for (std::size_t f = 0; f < scene->frames(); f += step) {
      const auto begin = Clock::now();
      engine.frame(scene->frame(f), work, answers);
      const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
      sum += seconds;
      us.push_back(1e6 * seconds);
      ledger().add(*scene, work, kind, f, seconds, answers);
    }
    state.SetIterationTime(sum);
  }
  state.counters["median_us"] = lowerQuantile(us, 0.5);
  state.counters["p99_us"] = lowerQuantile(us, 0.99);
}

}  // namespace

Ledger& ledger() {
  static Ledger all;
  return all;
}

void registerSideBySide() {
  static const Entry kEntries[] = {
      {"spheres", threeSpheres, {Work::kDistance, Work::kContact, Work::kCollide}},
      {"rods", rods, {Work::kDistance, Work::kContact, Work::kCollide}},
      {"arms_person_table",
       armsPersonTable,
       {Work::kDistance, Work::kContact, Work::kCollide, Work::kSmallest}},
      {"bunnies", bunnyOnBunny, {Work::kDistance, Work::kContact, Work::kCollide}},
      {"peg", pegInHole, {Work::kDistance, Work::kContact, Work::kCollide}},
  };
  for (const Entry& e : kEntries)
    for (const Work work : e.works)
      for (const Kind kind : kKinds) {
        if (!available(kind)) continue;
        std::string name = std::string("sideBySide/") + e.name + "/" + shortName(work) + "/";
        name += kindName(kind);
        benchmark::RegisterBenchmark(
            name.c_str(),
            [make = e.make, work, kind](benchmark::State& state) { sideBySide(state, make, work, kind); })
            ->Iterations(1)
            ->UseManualTime()
            ->Unit(benchmark::kMicrosecond);
      }
}

}  // namespace abstand::bench
