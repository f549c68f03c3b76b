// Robots: kinematics from a file.
#pragma once

#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "abstand/mesh.hpp"

namespace abstand {

/// What a degree of freedom may do, rad or m (and per second). Infinite where the file does not say.
struct JointLimits {
  double lower{-std::numeric_limits<double>::infinity()};    ///< rad or m
  double upper{std::numeric_limits<double>::infinity()};     ///< rad or m
  double velocity{std::numeric_limits<double>::infinity()};  ///< rad/s or m/s, of its size
  double effort{std::numeric_limits<double>::infinity()};    ///< N m or N, of its size
};

/// A geometry that the file gives to a frame.
struct LinkBody {
  int frame{-1};                                   ///< index of the frame; -1: the base
  bool collision{true};                            ///< else for drawing only
  std::optional<Shape> shape;                      ///< none for a mesh
  std::filesystem::path mesh;                      ///< the mesh's file; empty: a shape, or it was not found
  std::string mesh_name;                           ///< as the robot's file writes it
  Eigen::Vector3d scale{Eigen::Vector3d::Ones()};  ///< of the mesh, metres per unit along its axes
  Pose X_FG{Pose::Identity()};                     ///< the geometry in the frame
};

/// A tree of frames joined by fixed, revolute and prismatic joints. Constant, shared by copies; any number of
/// threads may use one at once.
class Mechanism {
 public:
  /// Reads URDF, or a Denavit-Hartenberg table `.mech` (thesis 3.1.4). Meshes are looked for beside the file,
  /// in `packages` and in ROS's packages, and not opened. Throws std::runtime_error, one line
  /// `FILE:LINE:COLUMN: error: WHAT` (and a second line with a hint).
  static Mechanism load(const std::filesystem::path& file,
                        const std::vector<std::filesystem::path>& packages = {});

  const std::string& name() const;                 ///< as the file says, or its stem
  int dof() const;                                 ///< degrees of freedom: joint values
  std::size_t frames() const;                      ///< parents come first
  std::string frameName(std::size_t frame) const;  ///< the link's name; of a `.mech` file its number
  int parent(std::size_t frame) const;             ///< -1: the base
  /// Index of a frame, or -1.
  int frame(const std::string& name) const;
  /// Of a joint value; throws std::runtime_error unless 0 <= value < dof().
  JointLimits limits(int value) const;
  /// Name of the joint that a joint value moves; empty where the file has none.
  std::string jointName(int value) const;
  /// In the file's order.
  const std::vector<LinkBody>& bodies() const;
  /// What is odd in the file, `FILE:LINE:COLUMN: TEXT`.
  const std::vector<std::string>& warnings() const;

  /// Poses of all frames in the base's frame, for joint values q (rad, m; dof() of them) [Craig, Introduction
  /// to Robotics, eq. 3.6]. Throws std::runtime_error for another number of them. Any thread.
  std::vector<Pose> forward(std::span<const double> q) const;
  /// 6 x dof: linear velocity of the frame's origin, then angular velocity, in the base's axes, per unit of
  /// q.
  Eigen::Matrix<double, 6, Eigen::Dynamic> jacobian(std::span<const double> q, std::size_t frame) const;

  /// @cond library
  struct Impl;
  explicit Mechanism(std::shared_ptr<const Impl> impl) : impl_(std::move(impl)) {}
  const Impl& impl() const { return *impl_; }
  /// @endcond

 private:
  std::shared_ptr<const Impl> impl_;
};

}  // namespace abstand
