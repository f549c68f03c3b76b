// Snapshot of a running session for the window: plain values, copied once in each cycle.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/control/reaction_description.hpp"
#include "core/mechanism/joint_axis.hpp"
#include "core/mechanism/joint_limit_watch.hpp"
#include "core/safety/stop_machine.hpp"
#include "core/scene/scene.hpp"
#include "core/view/body_card.hpp"
#include "core/view/pair_class.hpp"
#include "core/view/recording_card.hpp"
#include "core/view/robot_drive.hpp"

namespace abstand::view {

struct ObjectSnapshot {
  Transform X_WB{Transform::Identity()};
  scene::PoseState pose_state{scene::PoseState::kFresh};
  Vector3d p_WCom{Vector3d::Zero()};
  Twist velocity;
  Wrench contact;
  double margin{0.0};
  bool colliding{false};
  double pose_uncertainty{0.0};  ///< m, see Object
};

struct PairSnapshot {
  query::PairResult result;
  double margin{0.0};
  bool paused{false};  ///< see Scene::setPaused: the result is stale
};

inline constexpr std::size_t kTorqueParts = 4;
/// Efforts on a joint, N m or N, positive in the direction of increasing joint value.
struct TorqueParts {
  double contact{0.0};   ///< J^T of the contact wrenches on the links, including margins
  double reaction{0.0};  ///< added to the motors by the reaction
  double gravity{kNaN};  ///< of the links' weight; NaN: the mechanism's file has no masses
  double motion{kNaN};   ///< of their inertia in the current motion; NaN: likewise
  /// Part number `part` in the order above.
  double operator[](std::size_t part) const {
    return part == 0 ? contact : part == 1 ? reaction : part == 2 ? gravity : motion;
  }
};

/// State of a group of pairs set by the user; results of pairs in a group that is not running are stale.
enum class PairGroupState : std::uint8_t { kRunning, kPaused, kStopped };

struct PairGroupSnapshot {
  PairGroupState state{PairGroupState::kRunning};
  std::size_t pairs{0};  ///< number of pairs
};

/// State of a reacting robot in the last cycle.
struct RobotSnapshot {
  safety::StopState state{safety::StopState::kRunning};
  safety::StopCause cause;  ///< of the present state; in kRunning: of the state before
  double since{0.0};        ///< s, when the state began
  double speed_scale{1.0};  ///< 0 to 1, share of the planned speed
  long refused_resets{0};   ///< since SceneSnapshot::loop_start
  safety::ResetRefusal refusal{safety::ResetRefusal::kNone};  ///< of the last refused reset
  safety::StopLog log;  ///< changes before the present state, since SceneSnapshot::loop_start
  /// Worst violation of each joint and kind of limit since SceneSnapshot::loop_start: the first ones, and
  /// their total number.
  std::array<mechanism::LimitBreach, 16> breaches;
  std::size_t breach_count{0};
};

/// A force that the user applies to a link.
struct PokeSnapshot {
  int object{-1};                      ///< -1: none
  Vector3d p_W{Vector3d::Zero()};      ///< m, where it acts
  Vector3d force_W{Vector3d::Zero()};  ///< N
};

/// What moves robots and people.
struct MoverSnapshot {
  PokeSnapshot poke;
  std::vector<bool> by_hand;                     ///< for each of SceneOutline::robots: posed by hand
  std::vector<mechanism::JointAxis> joint_axes;  ///< of all joints, in the world
  std::vector<double>
      person_age;  ///< s, for each of SceneOutline::people: longest time since a part was seen
};

/// Sizes are fixed when the session opens, so copying does not allocate. Indices are those of the scene.
struct SceneSnapshot {
  long step{0};
  long captured{-1};  ///< Scene::steps() at the last capture() into this one
  double t{0.0};      ///< s, simulation time
  std::vector<ObjectSnapshot> objects;
  std::vector<PairSnapshot> pairs;
  std::vector<double> joint_positions;  ///< all mechanisms, concatenated (rad, m)
  std::vector<double> joint_efforts;    ///< N m, N: due to the contact forces
  std::vector<TorqueParts> joint_torques;
  std::vector<PairGroupSnapshot> groups;  ///< in the order of SceneOutline::pair_groups
  std::vector<int> pair_group;            ///< group of each pair, -1: none
  bool torques_on{true};                  ///< the reactions' torques are sent to the motors
  double cycle_us{0.0};                   ///< us, last cycle
  double cycle_median_us{0.0}, cycle_p99_us{0.0};
  double step_s{1e-3};            ///< s of wall time available for a cycle, chosen by the loop
  long played_cycles{0};          ///< since playing began or its speed changed
  long overruns{0};               ///< of these, those longer than step_s
  scene::StepCounts work;         ///< outcomes of the pairs in the last step
  double real_time_factor{kNaN};  ///< scene time over wall time; NaN if unknown
  /// In the order of SceneOutline::reacting; empty if nothing reacts.
  std::vector<RobotSnapshot> robots;
  double loop_start{kNaN};  ///< s, when they were last reset to their plans; NaN: never
  long loops{0};            ///< incremented by each such reset
  MoverSnapshot movers;
  bool playing{false};
  int nearest_pair{-1};  ///< index of the pair with the smallest distance, -1 without pairs
};

/// Fills objects, pairs, work and nearest_pair (the first of equal ones; pairs never queried do not count),
/// as of the last step(); other members are unchanged. A snapshot belongs to one scene: only changes since
/// the last capture are copied. Does not allocate if the sizes are right.
void capture(const scene::Scene& scene, SceneSnapshot& snapshot);

/// Constant data of an open scene: names, groups and pairs, for the tree and the tables.
struct SceneOutline {
  struct ObjectInfo {
    std::string name, group;
    bool human{false};
    bool moving{false};
  };
  struct JointInfo {
    std::string mechanism, name;
    bool prismatic{false};
    double lower{-kInfinity}, upper{kInfinity};  ///< rad or m, of its value; infinite: no limit
    double effort{kInfinity};                    ///< N m or N, absolute value; infinite: no limit
  };
  std::vector<ObjectInfo> objects;
  std::vector<std::pair<int, int>> pairs;
  std::vector<JointInfo> joints;
  std::vector<std::string> pair_groups;
  std::vector<std::string> reacting;                    ///< mechanisms with a `reaction`
  std::vector<control::ReactionDescription> reactions;  ///< of these, as in the scene file; empty: not
                                                        ///< known here, for a server decides
  std::vector<RobotDrive> drives;                       ///< of `reacting`; empty: nothing is changed here
  bool falls{false};                                    ///< some objects have a mass
  std::string cannot_react;                             ///< why the closed loop cannot run; empty: it can
  std::vector<geometry::TriangleMesh> meshes;           ///< one for each object, body frame, for drawing
  double start{0.0}, end{0.0};                          ///< s
  double frame_period{0.01};                            ///< s, one step of the timeline
  std::string title;
  std::vector<RecordingCard> recordings;  ///< of the people that have one
  std::vector<BodyCard> bodies;           ///< for each object
  std::vector<RobotCard> robots;          ///< all mechanisms
  std::vector<PersonCard> people;
  std::vector<UncheckedPair> unchecked;      ///< all pairs of objects that are not in `pairs`, by a, then b
  std::vector<std::string> unchecked_notes;  ///< reasons that files give for them
};

/// One point of the live plots.
struct PlotSample {
  double t{0.0};
  double min_distance{0.0};                     ///< m
  ClassDistances class_distance{kNoDistances};  ///< m, smallest of each class
  double contact_force{0.0};  ///< N, largest of a pair whose surfaces touch (safety::isTouching)
  double virtual_force{0.0};  ///< N, largest of a pair that is inside its margin and does not touch
  TorqueParts peak_torque{0.0, 0.0, 0.0, 0.0};  ///< N m or N, largest magnitudes of all joints
  double cycle_s{0.0};                          ///< s of wall time that the cycle took
  double step_s{1e-3};                          ///< s that it had, see SceneSnapshot
  int nearest_pair{-1};                         ///< as SceneSnapshot::nearest_pair
  bool played{false};                           ///< not for a seek or a step
  long margin_edits{0};  ///< changes of margins before it; forces and torques hold for these margins only
};

}  // namespace abstand::view
