// A session that plays on its own thread.
#pragma once

#include <atomic>
#include <thread>
#include <variant>

#include "app/session/session.hpp"
#include "core/base/spsc_ring.hpp"
#include "core/base/triple_buffer.hpp"

namespace abstand {

/// Wishes to the loop, as values.
namespace command {
struct Play {
  bool on;
};
struct Step {
  int frames;
};
struct Seek {
  double t;
};
struct Speed {
  double factor;
};
struct Loop {
  bool on;
};
struct Margin {
  int object;
  double metres;
};
}  // namespace command
using Command =
    std::variant<command::Play, command::Step, command::Seek, command::Speed, command::Loop, command::Margin>;

/// Owns a session and steps it on a thread of its own at 1 kHz of wall time; where cycles take longer than
/// that, in the smallest whole number of milliseconds that they fit into, so that play keeps real time. One
/// other thread (the window) sends commands and takes snapshots; nobody waits for anybody.
class LiveSession {
 public:
  /// Starts paused at `t`, with a first snapshot there.
  LiveSession(std::unique_ptr<Session> session, double t);
  ~LiveSession();

  const SceneOutline& outline() const { return outline_; }
  /// False when the loop is so far behind that the command was dropped.
  bool send(const Command& command) { return commands_.push(command); }
  bool takeSnapshot(SceneSnapshot& out);
  void drainPlot(std::vector<PlotSample>& out) { plot_.drainInto(out); }
  /// Plot samples that found no room.
  long samplesLost() const { return samples_lost_.load(std::memory_order_relaxed); }

 private:
  struct Timing;
  void cycle(Timing& timing);
  void loop(Timing& timing);
  void obey(const Command& command);
  void advance(double dt);
  void publish(const Timing& timing);

  std::unique_ptr<Session> session_;
  SceneOutline outline_;
  SpscRing<Command, 256> commands_;
  TripleBuffer<SceneSnapshot> snapshots_;
  SpscRing<PlotSample, 16384> plot_;
  std::atomic<long> samples_lost_{0};
  std::atomic<bool> stop_{false};

  // Loop thread only, once it runs.
  std::unique_ptr<Timing> timing_;
  std::vector<Command> pending_;
  double t_{0.0}, speed_{1.0};
  bool playing_{false}, looping_{true}, dirty_{true};
  long step_{0};

  std::jthread thread_;  // last: joined before the rest dies
};

}  // namespace abstand
