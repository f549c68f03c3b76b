// Our own engine in the benchmarks: only its public functions.
#include <algorithm>

#include "core/query/pair_set.hpp"
#include "tests/bench/engine.hpp"

namespace abstand::bench {
namespace {

/// The default tolerance of the library, include/abstand/query.hpp.
constexpr query::PairOptions kOptions{.far_share = query::farShareOf(query::kFarTolerance)};

class Abstand final : public Engine {
 public:
  explicit Abstand(const BenchScene& scene)
      : structures_(build(scene)), pairs_(pairsOf(scene, structures_)), results_(scene.pairs.size()) {}

  void frame(const Transform* X_WB, Work work, std::span<Answer> answers) override {
    const std::span poses(X_WB, structures_.size());
    switch (work) {
      case Work::kDistance:
        // Force and torques come with it.
        pairs_.distances(poses, kOptions, results_);
        for (std::size_t i = 0; i < answers.size(); ++i)
          answers[i] = {results_[i].distance, results_[i].bound};
        break;
      case Work::kContact:
      case Work::kCollide:
        std::ranges::fill(answers, Answer{0.0, kNaN});
        for (const query::PairSet::Touch& touch : pairs_.contacts(poses, kOptions))
          answers[touch.pair].value = work == Work::kContact ? touch.penalty.depth : 1.0;
        break;
      case Work::kSmallest: {
        const query::PairResult& nearest = pairs_.nearest(poses, kOptions).result;
        answers[0] = {nearest.distance, nearest.bound};
      }
    }
  }

 private:
  using Structures = std::vector<std::shared_ptr<const structure::HapticStructure>>;

  static Structures build(const BenchScene& scene) {
    Structures structures;
    for (const auto& body : scene.bodies) {
      const std::shared_ptr<const geometry::Surface> surface = geometry::makeSurface(body.mesh);
      structures.push_back(structure::buildHapticStructure(body.name, surface, scene.options));
    }
    return structures;
  }
  static query::PairSet pairsOf(const BenchScene& scene, const Structures& structures) {
    std::vector<const structure::HapticStructure*> bodies;
    for (const auto& s : structures) bodies.push_back(s.get());
    std::vector<query::PairSet::Bodies> pairs;
    for (const auto& [a, b] : scene.pairs)
      pairs.push_back({static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b)});
    return {std::move(bodies), std::move(pairs)};
  }

  Structures structures_;
  query::PairSet pairs_;
  std::vector<query::PairResult> results_;
};

}  // namespace

std::unique_ptr<Engine> openAbstand(const BenchScene& scene) { return std::make_unique<Abstand>(scene); }

}  // namespace abstand::bench
