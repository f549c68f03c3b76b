// The closed loop in live mode: pairs on threads of their own, in real time.
#pragma once

#include "app/loop/closed_loop.hpp"
#include "core/base/pacer.hpp"
#include "core/scene/pair_threads.hpp"

namespace abstand::run {

/// What a cycle of live mode waits for before it collects results.
enum class LivePace {
  kRealTime,  ///< the end of its period on the wall clock
  kSettled,   ///< completion of the current poses by every group: results are never old
};
/// Collects until every group has finished the current poses; yields the processor meanwhile.
void settle(scene::PairThreads& threads, std::vector<query::PairResult>& results);

/// A cycle takes a millisecond of wall time: poses are updated, the groups of pairs have the rest of the
/// millisecond, and robots react to the newest results available then. Slower groups lag behind, and robots
/// with pairs older than `stop.input_age` stop. Results depend on the machine. One calling thread.
class LiveLoop {
 public:
  /// Robots start on their plans at `t`. Throws ParseError for a robot that cannot react, UsageError if a
  /// pair of one is not in a group. The session must outlive this object. `pace`: what a cycle waits for.
  LiveLoop(session::Session& session, double t, std::vector<std::vector<PairId>> groups,
           LivePace pace = LivePace::kRealTime);

  /// Runs the cycle at loop().time(); `results`: one for each pair of the scene. Returns the working time of
  /// this thread (s).
  double cycle(std::vector<query::PairResult>& results);
  const loop::ClosedLoop& loop() const { return loop_; }
  scene::StepCounts counts() const { return threads_.counts(); }

 private:
  session::Session& session_;
  loop::ClosedLoop loop_;
  scene::PairThreads threads_;
  std::vector<PairId> felt_;  ///< pairs of reacting robots
  LivePace pace_;
  Pacer pacer_;
};

}  // namespace abstand::run
