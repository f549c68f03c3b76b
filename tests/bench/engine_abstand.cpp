// Our own engine in the benchmarks: only its public functions.
#include <algorithm>

#include "core/haptic/pair_query.hpp"
#include "tests/bench/engine.hpp"

namespace abstand::bench {
namespace {

class Abstand final : public Engine {
 public:
  explicit Abstand(const BenchScene& scene)
      : pairs_(scene.pairs),
        memories_(pairs_.size()),
        centres_(scene.bodies.size()),
        smallest_(pairs_.size()) {
    for (const auto& body : scene.bodies) {
      const std::shared_ptr<const Surface> surface = makeSurface(body.mesh);
      structures_.push_back(buildHapticStructure(body.name, surface, scene.options));
    }
  }

  void frame(const Transform* X_WB, Work work, std::span<Answer> answers) override {
    X_WB_ = X_WB;
    if (work != Work::kDistance)
      for (std::size_t i = 0; i < centres_.size(); ++i)
        centres_[i] = X_WB[i] * structures_[i]->bounding_sphere.centre;
    if (work == Work::kSmallest) {
      answers[0] =
          smallest_.find([&](std::size_t i) { return gap(i); }, [&](std::size_t i) { return ask(i); });
      return;
    }
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      if (work == Work::kDistance) {
        answers[i] = ask(i);
        continue;
      }
      // Bodies whose spheres are apart do not touch, and need no query.
      const double depth = gap(i) > 0.0 ? 0.0 : std::max(0.0, -ask(i).value);
      answers[i].value = work == Work::kContact ? depth : static_cast<double>(depth > 0.0);
    }
  }

 private:
  double gap(std::size_t i) const {
    const auto [a, b] = pairs_[i];
    return (centres_[a] - centres_[b]).norm() - structures_[a]->bounding_sphere.radius -
           structures_[b]->bounding_sphere.radius;
  }
  /// One call gives the distance, its bound, the nearest points, force and torques.
  Answer ask(std::size_t i) {
    const auto [a, b] = pairs_[i];
    queryPair(*structures_[a], X_WB_[a], *structures_[b], X_WB_[b], {}, memories_[i], scratch_, result_);
    return {result_.distance, result_.bound};
  }

  std::vector<std::pair<std::size_t, std::size_t>> pairs_;
  std::vector<std::shared_ptr<const HapticStructure>> structures_;
  std::vector<PairMemory> memories_;
  std::vector<Vector3d> centres_;
  SmallestSearch smallest_;
  const Transform* X_WB_{nullptr};
  PairScratch scratch_;
  PairResult result_;
};

}  // namespace

std::unique_ptr<Engine> openAbstand(const BenchScene& scene) { return std::make_unique<Abstand>(scene); }

}  // namespace abstand::bench
