// Closed loop of 1 ms cycles: people move as recorded, robots react to them.
#pragma once

#include "app/loop/poke.hpp"
#include "app/loop/reacting_robot.hpp"
#include "app/session/session.hpp"

namespace abstand::loop {

/// One cycle at time t:
///   1. people and objects move to their poses at t, links to those of the physics
///   2. pairs are queried
///   3. forces on links, joint efforts J^T F, Reaction, motor commands; touching bodies push each other
///   4. the physics advances to t + kStep
/// Objects with a `mass` are bodies of the physics: they fall, rest and are pushed, unless `--poses` moves
/// them. Mechanisms without a `reaction` follow their motion. People follow their recording, whatever pushes
/// them. Bodies push each other where their surfaces overlap; contacts within margins only affect the
/// reaction. A robot that is posed by hand (MechanismDriver) stands as it is posed: it neither reacts nor is
/// pushed, and its stop machine rests; the others go on. Loop thread only; step() does not allocate (except
/// within libraries) after the first call, and does not throw.
class ClosedLoop {
 public:
  static constexpr double kStep = 1e-3;  ///< s

  /// Reactions that replace those of the scene, by mechanism; nullopt, or fewer: that of the scene.
  using Reactions = std::vector<std::optional<control::ReactionDescription>>;

  /// Robots start on their plans at `t`. Throws ParseError, UsageError. The session must outlive this object.
  ClosedLoop(session::Session& session, double t, const Reactions& reactions = {});

  /// Runs the cycle at time().
  void step();
  /// The two halves of step(), for callers that query the pairs in between: move() sets all poses for time().
  void move();
  void react() { react(0.0); }
  /// Reactions and physics, from the scene's current results. `age`: s, of the oldest result of a pair;
  /// beyond `stop.input_age` robots stop for stale input.
  void react(double age);
  /// Shows time() without advancing: poses, pairs, joint efforts. step() repeats it.
  void refresh();
  /// Releases every robot that waits for a reset, in the next cycle.
  void resetStops();
  /// Whether the torques of the reactions are sent to the motors, from the next cycle on.
  void setTorques(bool on);
  /// Exchanges the laws of a robot (index of the session's mechanisms, with a reaction) with those of `next`,
  /// from the next cycle on; see ReactingRobot. Not in the cycle: may allocate.
  void exchangeLaws(std::size_t mechanism, control::Reaction& next);
  /// From the next cycle on until it is replaced; nullopt: none. Without effect on bodies that are not links
  /// of a robot with a reaction.
  void setPoke(const std::optional<Poke>& poke);
  /// Sets robots, poke and loop_start; one that is posed by hand counts as running. No allocation once `out`
  /// has its sizes.
  void capture(view::SceneSnapshot& out) const;
  double start() const { return start_; }  ///< s, of the first cycle
  double time() const { return t_; }       ///< s, of the next cycle
  /// In the order of the session's mechanisms; null without a reaction.
  const std::vector<std::unique_ptr<ReactingRobot>>& robots() const { return robots_; }
  const session::Session& session() const { return session_; }

  /// Number of objects moved by the physics.
  std::size_t freeThings() const { return things_.size(); }

 private:
  /// An object with a mass, and its index in the physics world.
  struct Thing {
    ObjectId object;
    int number;
  };
  /// What the user pokes, and the frame of the mechanism that it is a link of.
  struct Poked {
    Poke poke;
    std::size_t mechanism;
    int frame;
  };
  void addThings();
  bool byHand(std::size_t mechanism) const { return session_.mechanisms()[mechanism]->byHand(); }
  void standStill(std::size_t mechanism);
  void push(PairId id);
  /// m, world: where the poke acts; none if there is no poke, or the robot is posed by hand.
  std::optional<Vector3d> pokedPoint() const;

  session::Session& session_;
  physics::PhysicsWorld world_;
  std::vector<std::unique_ptr<ReactingRobot>> robots_;
  std::vector<std::vector<double>> still_;  ///< joint rates of 0, for each mechanism
  std::vector<Thing> things_;
  std::vector<physics::PhysicsObject> bodies_;  ///< for each object of the scene
  std::vector<bool> pushed_;                    ///< for each object: it is a body of the physics
  double start_, t_;
  long cycles_{0};
  physics::ContactOptions contact_;
  std::optional<Poked> poked_;
  kernels::PairScratch scratch_;
};

}  // namespace abstand::loop
