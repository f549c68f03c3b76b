// Sources of the cycles of a run: one step for each frame, a closed loop, or either of them live.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "app/run/run_scene.hpp"

namespace abstand::run {

/// State of one pass over frames. `results`: one for each pair, in scene order.
struct PassState {
  session::Session& session;
  const RunOptions& options;
  RunSummary& summary;
  std::vector<query::PairResult> results;
  std::vector<PairId> all;  ///< pairs of the scene
  std::vector<bool> stale;  ///< objects that were stale or rejected at some time

  PassState(session::Session& session, const RunOptions& options, RunSummary& summary);
  /// Copies the results that the scene updated in its last step.
  void takeRenewed();
  /// Marks the objects whose poses are stale or rejected now.
  void watchPoses();
};

/// One pass from its first frame to its last. One thread. frame() does not allocate after the first call.
class CycleSource {
 public:
  /// Called after each cycle, with its time and working time (s).
  using CycleDone = std::function<void(double t, double worked)>;

  virtual ~CycleSource() = default;
  /// Runs all cycles up to the frame at `t`.
  virtual void frame(double t, const CycleDone& done) = 0;
  /// Pairs whose results may have changed in the last cycle.
  virtual const std::vector<PairId>& updated() const = 0;
  /// The closed loop, or null.
  virtual const loop::ClosedLoop* loop() const { return nullptr; }
  /// After the last frame: collects counts of the pass.
  virtual void finish() {}
};

/// Creates the source for `state.options`; frames at `times`, the first of which is frame `first` of the
/// session. Throws ParseError for a robot that cannot react. `state` must outlive it.
std::unique_ptr<CycleSource> makeCycleSource(PassState& state, const std::vector<double>& times,
                                             std::size_t first);

}  // namespace abstand::run
