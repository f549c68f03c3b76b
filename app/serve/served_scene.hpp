// A scene that is moved by packets, and what is known of it after each cycle.
#pragma once

#include <memory>

#include "app/serve/served_robot.hpp"
#include "app/serve/state_packet.hpp"
#include "app/session/pair_control.hpp"

namespace abstand::serve {

struct ServedOptions {
  control::ReactionDescription reaction;  ///< of every mechanism; its watch says when input is stale
  std::size_t nearest{8};                 ///< pairs that are reported one by one
  /// A mechanism's own `reaction` of the scene goes before; when input is stale, and a finite resume_after,
  /// come from the one above.
  bool scene_first{false};
};

/// What a robot does unless told otherwise: contact torques as they are, speed and separation by ISO/TS
/// 15066.
control::ReactionDescription usualReaction();

/// Robots and people follow packets alone; motions and recordings of the scene only say how it looks before.
/// One thread; nothing allocates or throws but the constructor.
class ServedScene {
 public:
  /// Throws UsageError.
  ServedScene(std::unique_ptr<session::Session> session, const ServedOptions& options);

  const PacketFormat& format() const { return format_; }
  const StateNames& names() const { return names_; }

  /// Takes a packet that parsePacket() accepted for format(). `t`: s, when it came; never falling.
  void take(const Packet& packet, double t);
  /// Obeys a control packet that parsePacket() accepted; from the cycle at `t` (s) on it holds.
  session::PairControl::Outcome obey(const Control& control, double t);
  const session::PairControl& control() const { return control_; }
  bool torquesOn() const { return report_.torques_on; }
  /// Poses, pairs, reactions at `t`.
  void cycle(double t);
  /// s: the time at which the next input becomes stale, infinite when all are.
  double nextStale() const;

  const StateReport& report() const { return report_; }
  StateReport& report() { return report_; }
  const std::vector<std::unique_ptr<ServedRobot>>& robots() const { return robots_; }
  const session::Session& session() const { return *session_; }
  /// What a user should know of the robots, a line each.
  const std::vector<std::string>& remarks() const { return remarks_; }

 private:
  struct Person {
    double last_t{-kInfinity};
    bool stale{true};
  };
  /// Of all pairs of a person and a robot.
  struct Separation {
    double found{kInfinity};   ///< m, the smallest distance,
    PairId pair{0};            ///< and of which pair
    double proven{kInfinity};  ///< m, the smallest distance - bound
  };
  void growPeople(double t);
  void reportLinks();
  void reportPairs();
  PairReport reportOf(PairId id) const;
  Trust trustOf(ObjectId id) const;
  Trust trustOf(const scene::Pair& pair) const;
  void addNearest(PairId id, double distance);

  std::unique_ptr<session::Session> session_;
  session::PairControl control_;
  control::WatchOptions watch_;
  PacketFormat format_;
  StateNames names_;
  std::vector<std::unique_ptr<ServedRobot>> robots_;
  std::vector<Person> people_;
  std::vector<ObjectId> links_;
  std::vector<int> separation_of_;  ///< of each pair: index into the report's separations, -1: none
  std::vector<Separation> separations_;
  std::vector<std::pair<double, PairId>> nearest_;
  std::size_t nearest_count_{0};
  StateReport report_;
  std::vector<std::string> remarks_;
};

}  // namespace abstand::serve
