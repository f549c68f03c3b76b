// A session that plays on its own thread.
#pragma once

#include <atomic>
#include <thread>
#include <variant>

#include "app/loop/closed_loop.hpp"
#include "app/loop/live_clock.hpp"
#include "app/loop/play_pace.hpp"
#include "app/session/joint_torques.hpp"
#include "app/session/pair_control.hpp"
#include "core/base/spsc_ring.hpp"
#include "core/base/triple_buffer.hpp"

namespace abstand::loop {

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
struct React {
  bool on;
};
struct ResetStops {};
struct Torques {
  bool on;
};
struct SetGroup {
  int group;
  view::PairGroupState state;
};
struct AddPair {
  int group, pair;
};
struct RemovePair {
  int pair;
};
}  // namespace command
using Command = std::variant<command::Play, command::Step, command::Seek, command::Speed, command::Loop,
                             command::Margin, command::React, command::ResetStops, command::Torques,
                             command::SetGroup, command::AddPair, command::RemovePair>;

/// Owns a session and steps it on a thread of its own at 1 kHz of wall time. One other thread (the window)
/// sends commands and takes snapshots; nobody waits for anybody.
///
/// While it plays, scene time follows wall time (PlayPace). Where a mechanism has a `reaction`, playing is
/// the closed loop: every millisecond of the scene has its cycle, and where they do not fit into wall time,
/// play is slower. What robots did depends on what was before, so a seek, a frame back and a new round put
/// them on their plans at that time (SceneSnapshot::loop_start). Else, and with React off, cycles show
/// recorded motion where wall time has come to: late ones leave moments out. They are asked for in steps of a
/// whole number of milliseconds, the smallest that the median cycle fits into.
class LiveSession {
 public:
  /// Starts paused at `t`, reacting, with a first snapshot there. Where a robot cannot react,
  /// outline().cannot_react says why, and nothing does. `clock`: null for the machine's.
  LiveSession(std::unique_ptr<session::Session> session, double t,
              std::unique_ptr<LiveClock> clock = nullptr);
  ~LiveSession();

  const view::SceneOutline& outline() const { return outline_; }
  /// False when the loop is so far behind that the command was dropped.
  bool send(const Command& command) { return commands_.push(command); }
  bool takeSnapshot(view::SceneSnapshot& out);
  void drainPlot(std::vector<view::PlotSample>& out) { plot_.drainInto(out); }

 private:
  struct Timing;
  template <class Work>
  void timed(Timing& timing, Work work);
  void cycle(Timing& timing);
  void reactOnce(Timing& timing);
  void stepFrames(int frames, Timing& timing);
  void end();
  void play(Timing& timing);
  void playRecorded(Timing& timing);
  void playClosed(Timing& timing);
  double step(const Timing& timing) const;
  void loop(Timing& timing);
  void obey(const Command& command, Timing& timing);
  void goTo(double t);
  void begin(double t);
  void closeLoop(double t);
  void findTorques();
  std::optional<PairId> pair(int index) const;
  void publish(const Timing& timing);

  std::unique_ptr<LiveClock> clock_;
  std::unique_ptr<session::Session> session_;
  view::SceneOutline outline_;
  SpscRing<Command, 256> commands_;
  TripleBuffer<view::SceneSnapshot> snapshots_;
  SpscRing<view::PlotSample, 16384> plot_;
  std::atomic<bool> stop_{false};

  // Loop thread only, once it runs.
  std::unique_ptr<Timing> timing_;
  std::unique_ptr<ClosedLoop> closed_;  ///< null: nothing reacts
  std::vector<Command> pending_;
  double t_{0.0}, speed_{1.0};
  PlayPace pace_;
  session::PairControl control_;
  std::vector<session::JointTorques> torques_of_;  ///< of each mechanism
  std::vector<view::TorqueParts> joint_torques_;   ///< of all joints
  bool torques_on_{true};
  bool playing_{false}, looping_{true};
  bool dirty_{true};  ///< t_ is not what the scene shows
  bool fresh_{true};  ///< there is something that no snapshot has
  long step_{0};
  long loops_{0};  ///< how often robots were put on their plans

  std::jthread thread_;  // last: joined before the rest dies
};

}  // namespace abstand::loop
