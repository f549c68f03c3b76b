// Sets of margins judged over an hour of recording, in blocks and frame by frame.
#include <benchmark/benchmark.h>

#include "core/margin/pair_margins.hpp"
#include "core/math/random.hpp"

namespace abstand::bench {
namespace {

constexpr std::size_t kHour = 360'000;  // frames at 100 Hz
constexpr double kPeriod = 0.01;        // s

/// Ten minutes of clearances, played again and again: a random walk between the robot and `farthest` (m).
struct Walk {
  std::size_t pairs, frames{60'000};
  std::vector<double> clearance, braking, between, none;

  Walk(std::size_t count, double farthest) : pairs{count} {
    Random random(1, 1);
    std::vector<double> c(pairs, 0.5 * farthest);
    for (std::size_t i = 0; i < frames; ++i) {
      double least = kInfinity;
      for (double& x : c) {
        x = std::clamp(x + random.between(-0.03, 0.03), 0.005, farthest);
        clearance.push_back(x);
        least = std::min(least, x);
      }
      between.push_back(least - 0.003);
      braking.push_back(least - 0.02);
    }
    none.assign(pairs, 0.0);
  }
  margin::PairFrame frame(std::size_t i) const {
    const std::size_t at = i % frames;
    return {kPeriod * static_cast<double>(i),
            {clearance.data() + at * pairs, pairs},
            none,
            none,
            between[at],
            braking[at]};
  }
};

std::vector<std::vector<margin::PairMargin>> randomSets(std::size_t sets, std::size_t pairs) {
  Random random(2, 2);
  std::vector<std::vector<margin::PairMargin>> all(sets);
  for (auto& set : all)
    for (std::size_t p = 0; p < pairs; ++p) set.push_back({random.between(0.0, 0.3), 0.0, 0.0});
  return all;
}

/// Arguments: sets, pairs, the farthest clearance in cm.
void marginSets(benchmark::State& state) {
  const auto count = static_cast<std::size_t>(state.range(0)),
             pairs = static_cast<std::size_t>(state.range(1));
  const Walk walk(pairs, 0.01 * static_cast<double>(state.range(2)));
  for (auto _ : state) {
    margin::PairMarginSets sets(randomSets(count, pairs), {});
    for (std::size_t i = 0; i < kHour; ++i) sets.add(walk.frame(i));
    benchmark::DoNotOptimize(sets.finish().front().stops);
  }
}
BENCHMARK(marginSets)
    ->Args({1000, 14, 200})
    ->Args({1000, 14, 40})
    ->Args({1000, 196, 200})
    ->Unit(benchmark::kMillisecond);

/// One set of 14 margins, each frame by itself.
void marginFrameByFrame(benchmark::State& state) {
  const Walk walk(14, 0.4);
  const std::vector<margin::PairMargin> set = randomSets(1, 14).front();
  for (auto _ : state) {
    margin::OutcomeStream stream({});
    for (std::size_t i = 0; i < kHour; ++i) {
      const margin::PairFrame frame = walk.frame(i);
      margin::MarginFrame all{frame.t, false, kInfinity, frame.between, frame.braking};
      for (std::size_t p = 0; p < set.size(); ++p) {
        all.inside = all.inside || frame.clearance[p] < set[p].margin;
        all.clearance = std::min(all.clearance, frame.clearance[p]);
      }
      stream.add(all);
    }
    benchmark::DoNotOptimize(stream.finish().stops);
  }
}
BENCHMARK(marginFrameByFrame)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace abstand::bench
