// A running scene: loads files, runs cycles. Shared by window, command line and tests. No Qt.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>

#include "app/session/human_driver.hpp"
#include "app/session/mechanism_driver.hpp"
#include "app/session/pair_groups.hpp"
#include "app/session/poses_file.hpp"
#include "app/session/structure_library.hpp"
#include "core/view/snapshot.hpp"

namespace abstand::session {

struct SessionOptions {
  std::filesystem::path recording;  ///< replaces the recording of every person; empty: as in the scene
  std::optional<bool> cut_things;   ///< replaces RecordingDescription::cut_things of every person
  double person_speed{1.0};         ///< factor of the recorded speed of people
  std::filesystem::path poses;      ///< `--poses`; empty: none
  int threads{0};                   ///< lock-step workers; 0: all cores
  /// Structures of objects by name, used instead of the geometry in the scene.
  std::map<std::string, std::shared_ptr<const structure::HapticStructure>> made;
  bool cache{true};                 ///< use the user's cache folder for structures
  structure::BuildMonitor monitor;  ///< of building the structures; its phase is the name of one
  /// Called with the number of tracked images of a depth recording, and of all. monitor.cancelled ends this,
  /// too.
  std::function<void(std::size_t done, std::size_t all)> tracked;
  bool keep_fits{false};  ///< HumanDriver::fitted() of depth recordings
  /// Called with the number of structures before the first is looked up or built.
  std::function<void(std::size_t structures)> planned;
  tracking::KnownObjects known;  ///< images of the robots as seen by a camera, for depth recordings that
                                 ///< request it
  std::optional<double> rest, horizon, budget;  ///< override the scene's `skipping`, as in QueryCulling
  std::optional<bool> remember;                 ///< likewise
  std::optional<double> far_tolerance;          ///< likewise
};

/// m/s. Default speed bound of a person's part if queries may be culled and the scene states none: the speed
/// of a hand in ISO 13855:2010. Boxing is faster; SpeedWatch detects it.
inline constexpr double kHandSpeed = 2.0;

/// Loads all files of a scene, builds the haptic structures, and runs cycles. Not shared between threads.
class Session {
 public:
  /// Throws ParseError, UsageError, and BuildCancelled or Interrupted when options.monitor ends it.
  Session(scene_file::SceneDescription description, const SessionOptions& options);

  /// One cycle at simulation time t: kinematics, poses, pairs, totals, joint efforts. After the first call no
  /// allocation and no throw.
  void step(double t);
  /// First part of step(): poses only; for live mode, where pairs run on threads of their own.
  void applyMotion(double t);
  /// The part of applyMotion() for `--poses`.
  void applyPoses(double t);
  /// Last part of step(): jointEfforts() from the scene's contacts.
  void sumEfforts();

  /// Puts a thing (an object of description().objects) somewhere else: without a motion, so that it has no
  /// velocity; a ClosedLoop takes over a falling one when it begins. False, and no effect, for other objects
  /// and for what is no pose. No allocation.
  bool placeThing(ObjectId id, const Transform& X_WB);
  /// Puts the recording of a person (index of description().humans) somewhere else, from the next step() on.
  void placePerson(std::size_t human, const Vector3d& xyz, double yaw);

  /// Puts the base of a robot (index of description().mechanisms) somewhere else, likewise. Not while a
  /// closed loop runs.
  void placeRobot(std::size_t mechanism, const Transform& X_WB);

  /// Times (s) of the frames: of the first recording; otherwise of the poses; otherwise every millisecond of
  /// the longest joint motion, or of 5 s if objects can fall; otherwise 0 only.
  std::vector<double> frameTimes() const;
  /// The same range at a fixed rate (Hz).
  std::vector<double> frameTimes(double rate) const;

  scene::Scene& scene() { return scene_; }
  const scene::Scene& scene() const { return scene_; }
  const scene_file::SceneDescription& description() const { return description_; }
  /// True if `--poses` moves this object.
  bool posed(ObjectId id) const;
  /// True if a mechanism has a `reaction` or an object a `mass`.
  bool reacts() const;
  const std::vector<std::unique_ptr<MechanismDriver>>& mechanisms() const { return mechanisms_; }
  const std::vector<std::unique_ptr<HumanDriver>>& humans() const { return humans_; }
  /// Pairs of object indices, a < b, that are adjacent according to their mechanism or person, independent of
  /// the scene's pair rules.
  const std::vector<std::pair<int, int>>& adjacentPairs() const { return adjacent_; }
  /// Every pair is in exactly one of them.
  const std::vector<PairGroup>& pairGroups() const { return pair_groups_; }
  const std::vector<double>& jointEfforts() const { return joint_efforts_; }
  double buildMs() const { return library_.buildMs(); }
  std::size_t structures() const { return library_.size(); }
  /// Number of structures from the cache.
  std::size_t cachedStructures() const { return library_.cached(); }
  /// Remarks for the user: about meshes, guesses, and gaps of recordings.
  const std::vector<std::string>& remarks() const { return remarks_; }
  const std::vector<MeshRemark>& meshRemarks() const { return library_.meshRemarks(); }
  /// Null without `--poses`.
  const PosesTable* poses() const { return poses_ ? &*poses_ : nullptr; }
  view::SceneOutline outline() const;
  /// Sets everything except the timing. No allocation once `out` has its sizes.
  void capture(double t, view::SceneSnapshot& out) const;

 private:
  /// A body before its structure is built; `placed` is called with the id of its object.
  struct Planned {
    std::string name, group;
    StructureLibrary::Key key;
    double margin;
    std::optional<double> max_speed;  ///< from the scene
    double usual_speed;               ///< m/s, default if the scene has none and queries may be culled
    std::function<void(ObjectId)> placed;
  };
  void planMechanisms(std::vector<Planned>& plan, const SessionOptions& options);
  void planHumans(std::vector<Planned>& plan, const SessionOptions& options);
  void planTool(std::vector<Planned>& plan, const SessionOptions& options,
                const scene_file::HumanDescription& person, const scene_file::ToolDescription& tool,
                int first_part);
  void planObjects(std::vector<Planned>& plan, const SessionOptions& options);
  template <class Body>
  StructureLibrary::Key request(const Body& body, const structure::HapticOptions& options);
  void selectAndAddPairs();
  void bindPoses(const std::filesystem::path& file);
  void setSpeeds(const std::vector<Planned>& plan);
  structure::HapticOptions hapticOptions(const scene_file::BodySettings& settings) const;

  scene_file::SceneDescription description_;
  scene::Scene scene_;
  StructureLibrary library_;
  std::vector<std::unique_ptr<MechanismDriver>> mechanisms_;
  std::vector<std::unique_ptr<HumanDriver>> humans_;
  std::optional<PosesTable> poses_;
  std::vector<ObjectId> poses_objects_;
  std::vector<std::pair<int, int>> adjacent_;
  std::vector<PairGroup> pair_groups_;
  std::vector<double> joint_efforts_;
  std::vector<std::string> remarks_;
};

}  // namespace abstand::session
