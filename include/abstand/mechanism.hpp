// Robots: kinematics from a robot file.
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

/// Limits of a degree of freedom. Infinite if the file does not specify one.
struct JointLimits {
  double lower{-std::numeric_limits<double>::infinity()};    ///< rad or m
  double upper{std::numeric_limits<double>::infinity()};     ///< rad or m
  double velocity{std::numeric_limits<double>::infinity()};  ///< rad/s or m/s, absolute value
  double effort{std::numeric_limits<double>::infinity()};    ///< N m or N, absolute value
};

/// Geometry of a frame.
struct LinkBody {
  int frame{-1};                                   ///< index of the frame; -1: the base
  bool collision{true};                            ///< false: only for display
  std::optional<Shape> shape;                      ///< empty for a mesh
  std::filesystem::path mesh;                      ///< mesh file; empty: a shape, or not found
  std::string mesh_name;                           ///< as in the robot file
  Eigen::Vector3d scale{Eigen::Vector3d::Ones()};  ///< of the mesh, metres per unit along its axes
  Pose X_FG{Pose::Identity()};                     ///< pose of the geometry in the frame
};

/// A tree of frames connected by fixed, revolute and prismatic joints. Constant, shared by copies; any number
/// of threads may use it at the same time.
class Mechanism {
 public:
  /// Reads URDF, or a Denavit-Hartenberg table `.mech` (thesis 3.1.4). Meshes are searched beside the file,
  /// in `packages` and in the ROS packages, but not opened. Throws std::runtime_error, one line
  /// `FILE:LINE:COLUMN: error: WHAT` (and optionally a second line with a hint).
  static Mechanism load(const std::filesystem::path& file,
                        const std::vector<std::filesystem::path>& packages = {});

  const std::string& name() const;                 ///< from the file, or its stem
  int dof() const;                                 ///< degrees of freedom: number of joint values
  std::size_t frames() const;                      ///< number of frames; parents come first
  std::string frameName(std::size_t frame) const;  ///< name of the link; in a `.mech` file, number
  int parent(std::size_t frame) const;             ///< -1: the base
  /// Index of a frame, or -1.
  int frame(const std::string& name) const;
  /// Limits of a joint value; throws std::runtime_error unless 0 <= value < dof().
  JointLimits limits(int value) const;
  /// Name of the joint of a joint value; empty if the file has none.
  std::string jointName(int value) const;
  /// Geometry of all frames, in the order of the file.
  const std::vector<LinkBody>& bodies() const;
  /// Warnings about the file, `FILE:LINE:COLUMN: TEXT`.
  const std::vector<std::string>& warnings() const;

  /// Poses of all frames in the base frame, for joint values q (rad, m; size dof()) [Craig, Introduction to
  /// Robotics, eq. 3.6]. Throws std::runtime_error for another size. Any thread.
  std::vector<Pose> forward(std::span<const double> q) const;
  /// 6 x dof: linear velocity of the origin of the frame, then angular velocity, in base axes, per unit of q.
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
