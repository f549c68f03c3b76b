#include "app/run/live_loop.hpp"

#include <algorithm>

#include "core/base/error.hpp"

namespace abstand::run {
namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

}  // namespace

void settle(scene::PairThreads& threads, std::vector<query::PairResult>& results) {
  for (threads.collect(results); !threads.upToDate(); threads.collect(results))
    std::this_thread::sleep_for(std::chrono::microseconds(20));
}

LiveLoop::LiveLoop(session::Session& session, double t, std::vector<std::vector<PairId>> groups,
                   LivePace pace)
    : session_(session),
      loop_(session, t),
      threads_(session.scene()),
      pace_(pace),
      pacer_(std::chrono::nanoseconds(static_cast<long>(1e9 * loop::ClosedLoop::kStep))) {
  loop_.refresh();
  threads_.publishPoses(session.scene());
  for (auto& group : groups) threads_.start(threads_.addGroup(std::move(group)));
  for (const auto& robot : loop_.robots()) {
    if (!robot) continue;
    for (const auto& own : robot->pairs().own()) felt_.push_back(own.id);
  }
  for (const PairId id : felt_) {
    if (threads_.resultTime(id) > -kInfinity) continue;
    const scene::Scene& scene = session.scene();
    const scene::Pair& pair = scene.pairs()[id.index()];
    throw UsageError("live: found pair `" + scene.object(pair.a).spec.name + "`, `" +
                     scene.object(pair.b).spec.name +
                     "` of a reacting robot outside every group of `threads`, expected it in a group");
  }
}

double LiveLoop::cycle(std::vector<query::PairResult>& results) {
  scene::Scene& scene = session_.scene();
  auto begin = Clock::now();
  loop_.move();
  threads_.publishPoses(scene);
  const double moving = secondsSince(begin);
  if (pace_ == LivePace::kRealTime) pacer_.wait();
  begin = Clock::now();
  if (pace_ == LivePace::kRealTime)
    threads_.collect(results);
  else
    settle(threads_, results);
  scene.setResults(results, threads_.resultTimes());
  double oldest = loop_.time();
  for (const PairId id : felt_) oldest = std::min(oldest, threads_.resultTime(id));
  loop_.react(loop_.time() - oldest);
  return moving + secondsSince(begin);
}

}  // namespace abstand::run
