// Extremes of the results of a run.
#pragma once

#include "app/run/run_scene.hpp"
#include "core/scene/directed_uncertainty.hpp"

namespace abstand::run {

/// Tracks the smallest distance, the largest force and the oldest result over a pass. One thread.
class Extremes {
 public:
  /// The session must outlive this object.
  explicit Extremes(const session::Session& session);

  /// `updated`: pairs whose results may differ from the last frame's; in the first frame all pairs.
  void frame(double t, const std::vector<query::PairResult>& results, const std::vector<PairId>& updated,
             RunSummary& summary);

  void finish(RunSummary& summary, RunMode mode) const;

  RunSummary::Extreme extreme(std::size_t pair, double t, double value) const;

 private:
  /// Smallest distance (m) of some pairs; of equal ones at a time the first in scene order, independent of
  /// the order of calls.
  struct Least {
    double value{kInfinity}, t{0.0};
    std::size_t pair{0};
    void offer(double d, double at, std::size_t i) {
      if (d < value || (d == value && at == t && i < pair)) *this = {d, at, i};
    }
  };
  std::optional<RunSummary::Extreme> extreme(const Least& least) const;
  void lookAtClearance(PairId id, double t, const query::PairResult& result) {
    const double uncertainty = scene::directedUncertainty(session_.scene(), id, result);
    clearance_.offer(result.distance - uncertainty, t, id.index());
  }

  const session::Session& session_;
  std::vector<bool> touching_;
  long touching_count_{0};
  Least distance_, clearance_;
  double force_{0.0}, force_t_{0.0};
  bool force_apart_{false};  ///< at force_: the distance is above its bound, so that no contact is possible
  std::vector<PairClass> classes_;
  std::array<Least, kPairClasses.size()> least_;
  double age_{-1.0}, age_t_{0.0};
  std::size_t force_pair_{0}, age_pair_{0};
};

}  // namespace abstand::run
