// Query times of single pairs.
#pragma once

#include <chrono>

#include "app/run/cold_query.hpp"
#include "app/run/extremes.hpp"

namespace abstand::run {

/// Times one pair in each frame, in turn, outside of the measured cycle.
class PairClock {
 public:
  explicit PairClock(const scene::Scene& scene)
      : sum_us_(scene.pairs().size()), count_(scene.pairs().size()) {}

  void sample(const scene::Scene& scene) {
    if (sum_us_.empty()) return;
    const auto begin = std::chrono::steady_clock::now();
    result_ = queryCold(scene, scene.pairs()[next_], scratch_);
    sum_us_[next_] +=
        std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - begin).count();
    ++count_[next_];
    next_ = (next_ + 1) % sum_us_.size();
  }

  void finish(const Extremes& extremes, RunSummary& summary) const {
    double worst = 0.0;
    for (std::size_t i = 0; i < sum_us_.size(); ++i) {
      if (count_[i] == 0 || sum_us_[i] / count_[i] <= worst) continue;
      worst = sum_us_[i] / count_[i];
      summary.slowest_pair = extremes.extreme(i, 0.0, worst);
    }
  }

 private:
  std::vector<double> sum_us_;
  std::vector<int> count_;
  std::size_t next_{0};
  kernels::PairScratch scratch_;
  query::PairResult result_;
};

}  // namespace abstand::run
