// The closed loop: people move as recorded, robots feel them and move away, millisecond by millisecond.
#pragma once

#include "app/loop/reacting_robot.hpp"
#include "app/session/session.hpp"

namespace abstand::loop {

/// One cycle at time t:
///   people and things to where they are at t, links to where the physics put them -> pairs
///   -> forces on links, joint efforts J^T F -> Reaction -> motors; bodies that touch push each other
///   -> the physics goes on to t + kStep
/// Things with a `mass` are bodies of the physics too: they fall, lie and are pushed, unless `--poses` moves
/// them. Mechanisms without a `reaction` follow their motion. People follow their recording, whatever pushes
/// them. Bodies push each other where their surfaces overlap; contacts within margins only ask the reaction.
/// Loop thread only; step() allocates nothing of ours after the first, and throws nothing.
class ClosedLoop {
 public:
  static constexpr double kStep = 1e-3;  ///< s

  /// Robots start on their plans at `t`. Throws ParseError, UsageError. The session must outlive it.
  ClosedLoop(session::Session& session, double t);

  /// The cycle at time().
  void step();
  /// Its two halves, for those who query the pairs in between: everything to where it is at time(), and, the
  /// scene's pairs being brought up, reactions and physics.
  void move();
  void react() { react(0.0); }
  /// `age`: s, of the oldest result of a pair; beyond `stop.input_age` robots stop for stale input.
  void react(double age);
  /// Shows the moment time() without going on: poses, pairs, joint efforts. step() does it again.
  void look();
  /// A person lets every robot that waits for it go on, in the next cycle.
  void resetStops();
  /// Whether the torques of the reactions reach the motors, from the next cycle on.
  void setTorques(bool on);
  /// Fills robots and loop_start. No allocation once `out` has its sizes.
  void capture(view::SceneSnapshot& out) const;
  double start() const { return start_; }  ///< s, of the first cycle
  double time() const { return t_; }       ///< s, of the next cycle
  /// A null for a mechanism without a reaction; in the order of the session.
  const std::vector<std::unique_ptr<ReactingRobot>>& robots() const { return robots_; }
  const session::Session& session() const { return session_; }

  /// Things that the physics moves.
  std::size_t freeThings() const { return things_.size(); }

 private:
  /// A thing with a mass, and its number in the world.
  struct Thing {
    ObjectId object;
    int number;
  };
  void addThings();
  void push(PairId id);

  session::Session& session_;
  physics::PhysicsWorld world_;
  std::vector<std::unique_ptr<ReactingRobot>> robots_;
  std::vector<Thing> things_;
  std::vector<physics::PhysicsObject> bodies_;  ///< of each object of the scene
  std::vector<bool> pushed_;                    ///< of each object: it is a body of the physics
  double start_, t_;
  long cycles_{0};
  physics::ContactOptions contact_;
  kernels::PairScratch scratch_;
};

}  // namespace abstand::loop
