// Many bodies over time: robots, people and things, from a scene file or put together here.
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

/// A person of a scene.
struct PersonOptions {
  double height{1.75};  ///< m, 0.5 to 2.5
  std::filesystem::path
      recording;  ///< any that docs/recordings.md lists, depth images too; empty: stands still
  /// m: where the recording's origin goes.
  Eigen::Vector3d place{Eigen::Vector3d::Zero()};
  double yaw{0.0};     ///< rad, about world z
  double margin{0.0};  ///< m, of every part
};

/// A robot of a scene.
struct RobotOptions {
  Pose X_WB{Pose::Identity()};                  ///< its base in the world
  std::vector<double> q;                        ///< rad, m: joint values; empty: all 0
  double margin{0.0};                           ///< m, of every link
  std::vector<std::filesystem::path> packages;  ///< folders of ROS packages
};

/// What a scene is put together from. Pairs are those of bodies of different robots, people and things. One
/// thread; a value.
class SceneBuilder {
 public:
  SceneBuilder();
  ~SceneBuilder();
  SceneBuilder(const SceneBuilder& other);             ///< independent of the other
  SceneBuilder& operator=(const SceneBuilder& other);  ///< likewise

  /// A thing with its structure. `margin`: m.
  SceneBuilder& addObject(const std::string& name, const Structure& structure,
                          const Pose& X_WB = Pose::Identity(), double margin = 0.0);
  /// URDF or `.mech`; a body NAME/FRAME for each frame with geometry. Throws std::runtime_error for the file.
  SceneBuilder& addRobot(const std::string& name, const std::filesystem::path& file,
                         const RobotOptions& options = {});
  /// Fourteen bodies NAME/torso, NAME/head, ... The recording is read by Scene.
  SceneBuilder& addPerson(const std::string& name, const PersonOptions& options = {});
  /// Of robots and people, m; at first 0.005.
  SceneBuilder& setResolution(double voxel_size, double point_spacing);
  /// N/m^3, of all contacts; at first 1e6.
  SceneBuilder& setStiffness(double stiffness);

  /// @cond library
  struct Impl;
  const Impl& impl() const { return *impl_; }
  /// @endcond

 private:
  std::unique_ptr<Impl> impl_;
};

/// How a scene runs.
struct SceneOptions {
  int threads{1};  ///< that share the pairs of a step, 1 to 256; 0: all cores. The bits do not depend on it.
  bool cache{true};  ///< of structures, as in StructureOptions
};

/// How trustworthy the pose of an object is; everything but kFresh never counts as safe.
enum class PoseState : std::uint8_t { kFresh, kInferred, kStale, kRejected };

/// Bodies, the pairs of them, and what robots and people do. World frame, SI. One thread at a time; different
/// scenes may run on different threads. Indices that do not exist throw std::out_of_range.
class Scene {
 public:
  /// Reads a scene file (docs/guide.md), builds its structures. Throws std::runtime_error, one line
  /// `FILE:LINE:COLUMN: error: WHAT` and a second one where there is a hint.
  static Scene load(const std::filesystem::path& file, const SceneOptions& options = {});
  /// Throws std::runtime_error for names that are taken and for files.
  explicit Scene(const SceneBuilder& builder, const SceneOptions& options = {});
  ~Scene();
  Scene(Scene&& other) noexcept;             ///< the other can only be assigned to
  Scene& operator=(Scene&& other) noexcept;  ///< likewise

  std::size_t objects() const;                              ///< bodies
  const std::string& objectName(std::size_t object) const;  ///< "person/torso"
  /// The body of this name, or none.
  std::optional<std::size_t> findObject(const std::string& name) const;
  std::size_t pairs() const;  ///< that are asked in every step
  /// The two bodies A and B of a pair.
  std::pair<std::size_t, std::size_t> pairObjects(std::size_t pair) const;
  std::size_t robots() const;        ///< in the order in which they were added
  std::size_t people() const;        ///< likewise
  int dof(std::size_t robot) const;  ///< joint values
  /// Times (s) of what is recorded: frames of the first recording, else every ms of a robot's motion, else 0.
  std::vector<double> frameTimes() const;
  /// What a user should know of files that were read, a sentence each.
  const std::vector<std::string>& remarks() const;

  /// Everything as recorded at time t (s), then all pairs. Pairs start from their last answer: beyond 0.1 m a
  /// distance may exceed the smallest one by 0.2 %, within its bound. No allocation after the first.
  void step(double t);
  /// The next step() or query() asks every pair from its poses alone; `abstand run` does so every 128 frames.
  void startCold();

  /// Live: puts a body; t (s) rises. False, and the body keeps its pose and counts as rejected, for a pose
  /// that is not finite or no rotation.
  bool moveObject(std::size_t object, const Pose& X_WB, double t);
  /// Live: joint values (rad, m) at time t (s). Throws std::runtime_error unless there are dof() finite ones.
  void moveRobot(std::size_t robot, std::span<const double> q, double t);
  /// Live: a skeleton in the frame of the person's recording, at its own time t.
  void movePerson(std::size_t person, const Skeleton& skeleton);
  /// Live: all pairs at time t (s) as bodies were put last. Where a person was not seen for a while,
  /// uncertainty() grows.
  void query(double t);

  /// Of a pair, from the last step() or query(); NaN before that.
  PairResult result(std::size_t pair) const;
  /// m: by so much the bodies of a pair may be nearer than its distance says, as poses are old or uncertain.
  double uncertainty(std::size_t pair) const;
  /// The pair with the smallest distance; none before the first step and without pairs.
  std::optional<std::size_t> nearest() const;
  /// Pairs with contacts, in order.
  std::vector<std::size_t> touching() const;
  /// Of a body, in the world.
  Pose pose(std::size_t object) const;
  /// Of a body.
  PoseState poseState(std::size_t object) const;
  /// N, the sum of the contacts of a body.
  Eigen::Vector3d force(std::size_t object) const;
  /// N m, likewise, about its centre of mass.
  Eigen::Vector3d torque(std::size_t object) const;
  /// N m, N: what the contacts of a robot's links do to its joints (J^T w).
  std::vector<double> jointEfforts(std::size_t robot) const;
  /// rad, m: as they were set or recorded last.
  std::vector<double> jointValues(std::size_t robot) const;

 private:
  struct Impl;
  explicit Scene(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace abstand
