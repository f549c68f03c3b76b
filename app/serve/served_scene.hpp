// A scene moved by packets, and its state after each cycle.
#pragma once

#include <memory>

#include "app/serve/served_robot.hpp"
#include "app/serve/state_packet.hpp"
#include "app/session/pair_control.hpp"

namespace abstand::serve {

struct ServedOptions {
  control::ReactionDescription reaction;  ///< for every mechanism; its `stop` options define when input is
                                          ///< stale
  std::size_t nearest{8};                 ///< number of pairs reported individually
  /// A mechanism's own `reaction` in the scene has precedence, except for the limits of stale input and a
  /// finite resume_after from the one above.
  bool scene_first{false};
};

/// Default reaction: contact torques without gain, speed and separation by ISO/TS 15066:2016.
control::ReactionDescription usualReaction();

/// Robots and people follow packets only; motions and recordings of the scene only set the initial poses. One
/// thread; only the constructor allocates or throws.
class ServedScene {
 public:
  /// Throws UsageError.
  ServedScene(std::unique_ptr<session::Session> session, const ServedOptions& options);

  const PacketFormat& format() const { return format_; }
  const StateNames& names() const { return names_; }

  /// Applies a packet accepted by parsePacket() for format(). `t`: s, arrival time; never decreasing.
  void take(const Packet& packet, double t);
  /// Executes a control packet accepted by parsePacket(); effective from the cycle at `t` (s) on.
  session::PairControl::Outcome handle(const Control& control, double t);
  const session::PairControl& control() const { return control_; }
  bool torquesOn() const { return report_.torques_on; }
  /// Poses, pairs and reactions at `t`.
  void cycle(double t);
  /// s: time at which the next input becomes stale, infinite if all are.
  double nextStale() const;

  /// What the last cycle found, for a viewer. No allocation once `out` has the sizes of the scene.
  void capture(view::SceneSnapshot& out);

  const StateReport& report() const { return report_; }
  StateReport& report() { return report_; }
  const std::vector<std::unique_ptr<ServedRobot>>& robots() const { return robots_; }
  const session::Session& session() const { return *session_; }
  /// Remarks about the robots for the user, one line each.
  const std::vector<std::string>& remarks() const { return remarks_; }

 private:
  struct Person {
    double last_t{-kInfinity};
    bool stale{true};
  };
  /// Minimum over all pairs of a person and a robot.
  struct Separation {
    double found{kInfinity};   ///< m, smallest distance,
    PairId pair{0};            ///< and its pair
    double proven{kInfinity};  ///< m, smallest distance - bound
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
  std::vector<int> separation_of_;  ///< of each pair: index in the report's separations, -1: none
  std::vector<Separation> separations_;
  std::vector<std::pair<double, PairId>> nearest_;
  std::size_t nearest_count_{0};
  StateReport report_;
  double t_{0.0};  ///< s, of the last cycle
  std::vector<std::string> remarks_;
};

}  // namespace abstand::serve
