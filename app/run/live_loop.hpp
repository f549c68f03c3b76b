// The closed loop in live mode: pairs on threads of their own, in real time.
#pragma once

#include "app/loop/closed_loop.hpp"
#include "core/base/pacer.hpp"
#include "core/scene/pair_threads.hpp"

namespace abstand::run {

/// What a cycle of live mode waits for before it takes the results.
enum class LivePace {
  kRealTime,  ///< the end of its period on the wall clock
  kSettled,   ///< that every group has finished the present poses: no result is ever old
};
/// Collects until every group has finished the present poses; gives other threads the processor meanwhile.
void settle(scene::PairThreads& threads, std::vector<query::PairResult>& results);

/// A cycle takes a millisecond of wall time: everything goes to where it is, the groups of pairs have the
/// rest of the millisecond for these poses, and robots react to the newest results that are there then. A
/// group that needs longer is behind, and robots whose pairs are older than `stop.input_age` stop. What
/// happens depends on the machine. One thread calls.
class LiveLoop {
 public:
  /// Robots start on their plans at `t`. Throws ParseError for a robot that cannot react, UsageError where a
  /// pair of one is in no group. The session must outlive it.
  /// `pace`: what a cycle waits for.
  LiveLoop(session::Session& session, double t, std::vector<std::vector<PairId>> groups,
           LivePace pace = LivePace::kRealTime);

  /// The cycle at loop().time(); `results`: one a pair of the scene. Seconds that this thread worked.
  double cycle(std::vector<query::PairResult>& results);
  const loop::ClosedLoop& loop() const { return loop_; }
  scene::StepCounts counts() const { return threads_.counts(); }

 private:
  session::Session& session_;
  loop::ClosedLoop loop_;
  scene::PairThreads threads_;
  std::vector<PairId> felt_;  ///< pairs of robots that react
  LivePace pace_;
  Pacer pacer_;
};

}  // namespace abstand::run
