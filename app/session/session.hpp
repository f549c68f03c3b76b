// A running scene: files in, cycles out. The same object serves window, command line and tests. No Qt.
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
  bool cut_things{false};           ///< as RecordingDescription::cut_things, of every person
  double person_speed{1.0};         ///< people move this much faster than recorded
  std::filesystem::path poses;      ///< `--poses`; empty: none
  int threads{0};                   ///< lock-step workers; 0: all cores
  /// Of bodies by name, instead of what the scene says of their geometry.
  std::map<std::string, std::shared_ptr<const structure::HapticStructure>> made;
  bool cache{true};                 ///< look for structures in the user's cache folder, and keep them there
  structure::BuildMonitor monitor;  ///< of the structures; its word is the name of one
  /// Hears how many structures there will be, before the first is looked for or built.
  std::function<void(std::size_t structures)> planned;
  tracking::KnownThings known;  ///< what a camera sees of the robots, for depth recordings that ask for it
  std::optional<double> rest, horizon, budget;  ///< instead of the scene's `skipping`, as in QueryCulling
  std::optional<bool> remember;                 ///< likewise
  std::optional<double> far_tolerance;          ///< likewise
};

/// m/s. What a part of a person is taken to move at most where pairs may rest and the scene does not say: the
/// speed of a hand in ISO 13855. Who boxes is faster; the watch sees it.
inline constexpr double kHandSpeed = 2.0;

/// Loads everything that a scene names, builds the haptic structures, and steps. Not shared between threads.
class Session {
 public:
  /// Throws ParseError, UsageError.
  Session(scene_file::SceneDescription description, const SessionOptions& options);

  /// One cycle at simulation time t: kinematics, poses, pairs, totals, joint efforts. After the first call no
  /// allocation and no throw.
  void step(double t);
  /// The first half of step(): poses only, for live mode, where the pairs run on threads of their own.
  void applyMotion(double t);
  /// The part of applyMotion() that `--poses` moves.
  void applyPoses(double t);
  /// The last part of step(): jointEfforts() of the scene's contacts.
  void sumEfforts();

  /// Times (s) of the frames: of the first recording; else of the poses; else every millisecond of the
  /// longest joint motion, or of 5 s where things fall; else 0 alone.
  std::vector<double> frameTimes() const;
  /// The same range at a fixed rate (Hz).
  std::vector<double> frameTimes(double rate) const;

  scene::Scene& scene() { return scene_; }
  const scene::Scene& scene() const { return scene_; }
  const scene_file::SceneDescription& description() const { return description_; }
  /// `--poses` moves this object.
  bool posed(ObjectId id) const;
  /// Some mechanism has a `reaction`, or some thing a `mass`.
  bool reacts() const;
  const std::vector<std::unique_ptr<MechanismDriver>>& mechanisms() const { return mechanisms_; }
  const std::vector<std::unique_ptr<HumanDriver>>& humans() const { return humans_; }
  /// Numbers of objects, a < b, that their mechanism or person says are adjacent, whatever the scene makes of
  /// it.
  const std::vector<std::pair<int, int>>& adjacentPairs() const { return adjacent_; }
  /// Every pair is in one of them.
  const std::vector<PairGroup>& pairGroups() const { return pair_groups_; }
  const std::vector<double>& jointEfforts() const { return joint_efforts_; }
  double buildMs() const { return library_.buildMs(); }
  std::size_t structures() const { return library_.size(); }
  /// How many of the structures came from the cache.
  std::size_t cachedStructures() const { return library_.cached(); }
  /// What a user should know: remarks about meshes, guesses and gaps of recordings.
  const std::vector<std::string>& remarks() const { return remarks_; }
  const std::vector<MeshRemark>& meshRemarks() const { return library_.meshRemarks(); }
  /// Null without `--poses`.
  const PosesTable* poses() const { return poses_ ? &*poses_ : nullptr; }
  view::SceneOutline outline() const;
  /// Fills everything but the timing. No allocation once `out` has its sizes.
  void capture(double t, view::SceneSnapshot& out) const;

 private:
  /// A body before its structure is built; `placed` hears which object it became.
  struct Planned {
    std::string name, group;
    StructureLibrary::Key key;
    double margin;
    std::optional<double> max_speed;  ///< as the scene says
    double usual_speed;               ///< m/s, where it does not and pairs may rest
    std::function<void(ObjectId)> placed;
  };
  void planMechanisms(std::vector<Planned>& plan, const SessionOptions& options);
  void planHumans(std::vector<Planned>& plan, const SessionOptions& options);
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
