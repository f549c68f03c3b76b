// Scenes of robots, people and objects over time, from a scene file or a SceneBuilder.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "abstand/query.hpp"
#include "abstand/skeleton.hpp"

namespace abstand {

/// Parameters of a person in a scene.
struct PersonOptions {
  double height{1.75};  ///< m, 0.5 to 2.5
  std::filesystem::path
      recording;  ///< any format of docs/recordings.md, or depth images; empty: stands still
  /// m: world position of the origin of the recording.
  Eigen::Vector3d place{Eigen::Vector3d::Zero()};
  double yaw{0.0};     ///< rad, about world z
  double margin{0.0};  ///< m, of each part
};

/// Parameters of a robot in a scene.
struct RobotOptions {
  Pose X_WB{Pose::Identity()};                  ///< base in the world
  std::vector<double> q;                        ///< rad, m: joint values; empty: all 0
  double margin{0.0};                           ///< m, of each link
  std::vector<std::filesystem::path> packages;  ///< folders of ROS packages
};

/// Description of a scene. Its pairs are those of bodies of different robots, people and objects. One thread;
/// a value.
class SceneBuilder {
 public:
  SceneBuilder();
  ~SceneBuilder();
  SceneBuilder(const SceneBuilder& other);             ///< deep copy
  SceneBuilder& operator=(const SceneBuilder& other);  ///< likewise

  /// An object with its structure. `margin`: m.
  SceneBuilder& addObject(const std::string& name, const Structure& structure,
                          const Pose& X_WB = Pose::Identity(), double margin = 0.0);
  /// URDF or `.mech`; a body NAME/FRAME for each frame with geometry. Throws std::runtime_error for the file.
  SceneBuilder& addRobot(const std::string& name, const std::filesystem::path& file,
                         const RobotOptions& options = {});
  /// Fourteen bodies NAME/torso, NAME/head, ... The recording is read by Scene.
  SceneBuilder& addPerson(const std::string& name, const PersonOptions& options = {});
  /// Of robots and people, m; default 0.005.
  SceneBuilder& setResolution(double voxel_size, double point_spacing);
  /// N/m^3, of all contacts; default 1e6.
  SceneBuilder& setStiffness(double stiffness);

  /// @cond library
  struct Impl;
  const Impl& impl() const { return *impl_; }
  /// @endcond

 private:
  std::unique_ptr<Impl> impl_;
};

/// Options of a scene.
struct SceneOptions {
  int threads{1};    ///< for the pairs of a step, 1 to 256; 0: all cores; does not affect the bits
  bool cache{true};  ///< structure cache, as in StructureOptions
  bool cold{false};  ///< cold starts: each step depends on its poses alone (slower)
  /// QueryOptions::far_tolerance of warm starts; empty: as in the scene file, else 0.002.
  std::optional<double> far_tolerance{};
};

/// State of the pose of an object; only kFresh can count as safe.
enum class PoseState : std::uint8_t { kFresh, kInferred, kStale, kRejected };

/// Bodies and pairs of bodies, moved by robots and people. World frame, SI. One thread at a time; different
/// scenes may run on different threads. Invalid indices throw std::out_of_range.
class Scene {
 public:
  /// Reads a scene file (docs/guide.md) and builds its structures. Throws std::runtime_error, one line
  /// `FILE:LINE:COLUMN: error: WHAT` and optionally a second line with a hint.
  static Scene load(const std::filesystem::path& file, const SceneOptions& options = {});
  /// Throws std::runtime_error for duplicate names and for invalid files.
  explicit Scene(const SceneBuilder& builder, const SceneOptions& options = {});
  ~Scene();
  Scene(Scene&& other) noexcept;             ///< `other` can then only be assigned to
  Scene& operator=(Scene&& other) noexcept;  ///< likewise

  std::size_t objects() const;                              ///< number of bodies
  const std::string& objectName(std::size_t object) const;  ///< "person/torso"
  /// Index of the body with this name; empty if there is none.
  std::optional<std::size_t> findObject(const std::string& name) const;
  std::size_t pairs() const;  ///< number of pairs
  /// The two bodies A and B of a pair.
  std::pair<std::size_t, std::size_t> pairObjects(std::size_t pair) const;
  std::size_t robots() const;        ///< number, in the order of addition
  std::size_t people() const;        ///< likewise
  int dof(std::size_t robot) const;  ///< number of joint values
  /// Times (s) of the frames of the first recording; otherwise every ms of a robot motion; otherwise 0.
  std::vector<double> frameTimes() const;
  /// Remarks about the files that were read, one sentence each.
  const std::vector<std::string>& remarks() const;

  /// Moves all bodies as recorded at time t (s), then queries all pairs, with warm starts (SceneOptions). No
  /// allocation after the first call.
  void step(double t);
  /// Makes the next step() or query() a cold start for all pairs; `abstand run` does so every 128 frames.
  void startCold();

  /// Live: sets the pose of a body; t (s) increases. False for a pose that is not finite or not a rotation;
  /// the body then keeps its pose, and its state is kRejected.
  bool moveObject(std::size_t object, const Pose& X_WB, double t);
  /// Live: joint values (rad, m) at time t (s). Throws std::runtime_error unless there are dof() finite ones.
  void moveRobot(std::size_t robot, std::span<const double> q, double t);
  /// Live: a skeleton in the frame of the person's recording, at its own time t.
  void movePerson(std::size_t person, const Skeleton& skeleton);
  /// Live: queries all pairs at time t (s) with the last poses. uncertainty() grows while a person is not
  /// seen.
  void query(double t);

  /// Result of a pair from the last step() or query(); NaN before the first one.
  PairResult result(std::size_t pair) const;
  /// m: pose uncertainty of the pair; the true distance may be smaller by this, as poses are old or
  /// uncertain.
  double uncertainty(std::size_t pair) const;
  /// The pair with the smallest distance; empty before the first step and without pairs.
  std::optional<std::size_t> nearest() const;
  /// Pairs with contacts, in order of index.
  std::vector<std::size_t> touching() const;
  /// Pose of a body in the world.
  Pose pose(std::size_t object) const;
  /// Pose state of a body.
  PoseState poseState(std::size_t object) const;
  /// N, total contact force on a body.
  Eigen::Vector3d force(std::size_t object) const;
  /// N m, total contact torque on a body, about its centre of mass.
  Eigen::Vector3d torque(std::size_t object) const;
  /// N m, N: joint efforts of the contacts on the links of a robot (J^T w).
  std::vector<double> jointEfforts(std::size_t robot) const;
  /// rad, m: last set or recorded joint values.
  std::vector<double> jointValues(std::size_t robot) const;

 private:
  struct Impl;
  explicit Scene(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace abstand
