// A session that plays on a thread of its own.
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

/// Commands to the loop, as values.
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
/// Margin of all pairs of a class, which replaces the sums of the objects' margins; negative: the sums again.
struct ClassMargin {
  view::PairClass pair_class;
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
/// A joint (index of SceneOutline::joints) by hand; its robot then ignores its motion.
struct PoseJoint {
  int joint;
  double value;  ///< rad or m
};
/// Gives a robot (index of SceneOutline::robots) that was posed by hand back to its motion.
struct FollowMotion {
  int robot;
};
/// Puts a thing (index of SceneOutline::objects) at a pose in the world; nullopt: as in the scene file. One
/// that falls begins there, and the closed loop begins anew.
struct PlaceThing {
  int object;
  std::optional<Transform> X_WB;
};
/// Exchanges the laws of a robot (index of SceneOutline::reacting); made by LiveSession::laws(). Once it is
/// obeyed `next` holds the former laws, so that no memory is freed on the loop's thread.
struct Laws {
  int robot;
  std::shared_ptr<control::Reaction> next;
};
/// Pulls the point `p_B` (m, frame of the body) of an object of the scene to `target_W` (m, world), see
/// loop::Poke. Ends by EndPoke, or if it is not sent again within Poke::kTimeout.
struct Poke {
  int object;
  Vector3d p_B, target_W;
};
struct EndPoke {};
}  // namespace command
using Command =
    std::variant<command::Play, command::Step, command::Seek, command::Speed, command::Loop, command::Margin,
                 command::ClassMargin, command::React, command::ResetStops, command::Torques,
                 command::SetGroup, command::AddPair, command::RemovePair, command::PoseJoint,
                 command::FollowMotion, command::PlaceThing, command::Laws, command::Poke, command::EndPoke>;

/// Owns a session and runs it on its own thread at 1 kHz of wall time. One other thread (the window) sends
/// commands and takes snapshots; neither waits for the other.
///
/// While playing, scene time follows wall time (PlayPace). If a mechanism has a `reaction`, the closed loop
/// runs: every millisecond of the scene has its cycle, and play slows down if they do not fit into wall time.
/// The robots' state depends on the past, so a seek, a step back and a new round reset them to their plans at
/// that time (SceneSnapshot::loop_start), and so does giving back a robot with a `reaction` that was posed by
/// hand. Otherwise, and with React off, cycles show the recorded motion at
/// the current wall time; late cycles skip times. Their period is a whole number of milliseconds, the
/// smallest that the median cycle fits into.
class LiveSession {
 public:
  /// Starts paused at `t`, with reaction on and a first snapshot. If a robot cannot react,
  /// outline().cannot_react states why, and reaction is off. `clock`: null for the system clock.
  LiveSession(std::unique_ptr<session::Session> session, double t,
              std::unique_ptr<LiveClock> clock = nullptr);
  ~LiveSession();

  const view::SceneOutline& outline() const { return outline_; }
  /// False if the command queue is full: the command was dropped.
  bool send(const Command& command) { return commands_.push(command); }
  /// The command that gives a robot (index of SceneOutline::reacting) another reaction while it runs: stops
  /// that are active, and all other state, stay; a new beginning of the closed loop keeps the laws. With an
  /// admittance or a proxy more or less than before, the closed loop begins anew at the present time.
  /// Everything is checked here, on the window's thread, and allocated unless the loop begins anew. Throws
  /// UsageError for what does not fit the robot.
  command::Laws laws(int robot, const control::ReactionDescription& reaction) const;
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
  void handle(const Command& command, Timing& timing);
  void goTo(double t);
  void begin(double t);
  void closeLoop(double t);
  void findTorques();
  void poseJoint(int joint, double value);
  void followMotion(int robot);
  void exchangeLaws(int robot, control::Reaction& next);
  void placeThing(const command::PlaceThing& wanted);
  void setPoke(const command::Poke& wanted);
  void expirePoke();
  void endPoke();
  int mechanismOf(int robot) const;
  std::optional<PairId> pair(int index) const;
  void setClassMargin(const command::ClassMargin& wanted, Timing& timing);
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
  std::unique_ptr<ClosedLoop> closed_;  ///< null: no reaction
  std::vector<Command> pending_;
  double t_{0.0}, speed_{1.0};
  PlayPace pace_;
  session::PairControl control_;
  std::vector<session::JointTorques> torques_of_;  ///< for each mechanism
  std::vector<view::TorqueParts> joint_torques_;   ///< for all joints
  /// What the user has set, for every closed loop.
  struct {
    bool torques{true};
    std::vector<std::optional<control::ReactionDescription>> reactions;  ///< by mechanism; none: the scene's
    std::vector<Transform> things;  ///< poses of the things in the scene file
    std::optional<Poke> poke;
    double poke_end{0.0};  ///< s, of the clock
  } wishes_;
  bool playing_{false}, looping_{true};
  bool needs_cycle_{true};     ///< the scene does not show t_ yet
  bool needs_snapshot_{true};  ///< there are changes that no snapshot has
  long step_{0};
  long loops_{0};  ///< number of resets of the robots to their plans

  std::jthread thread_;  // last member: joined before the others are destroyed
};

}  // namespace abstand::loop
