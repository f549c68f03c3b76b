// Where the cycles of a run come from: a step a frame, a closed loop, or either of them live.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "app/run/run_scene.hpp"

namespace abstand::run {

/// A pass over frames: what every source works on. `results`: one a pair, in scene order.
struct PassState {
  session::Session& session;
  const RunOptions& options;
  RunSummary& summary;
  std::vector<query::PairResult> results;
  std::vector<PairId> all;  ///< pairs of the scene
  std::vector<bool> stale;  ///< objects that were stale or refused at some time

  PassState(session::Session& session, const RunOptions& options, RunSummary& summary);
  /// Takes the results of the pairs that the scene queried in its last step.
  void takeRenewed();
  /// Marks the objects whose poses are stale or refused now.
  void watchPoses();
};

/// One pass from its first frame to its last. One thread. Nothing in frame() allocates, but in the first.
class CycleSource {
 public:
  /// Called once a cycle, with its time and how long it worked (s).
  using CycleDone = std::function<void(double t, double worked)>;

  virtual ~CycleSource() = default;
  /// Runs all cycles up to the frame at `t`.
  virtual void frame(double t, const CycleDone& done) = 0;
  /// Pairs whose results the last cycle may have changed.
  virtual const std::vector<PairId>& renewed() const = 0;
  /// The loop in which robots react, or null.
  virtual const loop::ClosedLoop* loop() const { return nullptr; }
  /// After the last frame: what is counted once a pass.
  virtual void finish() {}
};

/// The source that `state.options` asks for; frames at `times`, the first of which is number `first` of the
/// session's. Throws ParseError for a robot that cannot react. `state` must outlive it.
std::unique_ptr<CycleSource> makeCycleSource(PassState& state, const std::vector<double>& times,
                                             std::size_t first);

}  // namespace abstand::run
