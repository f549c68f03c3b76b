// Forces, torques and velocities of all objects as arrows. VTK: .cpp files only.
#pragma once

#include <vtkRenderer.h>

#include <array>
#include <memory>

#include "core/view/snapshot.hpp"
#include "ui/document/view_options.hpp"
#include "ui/viewport/arrow_batch.hpp"

namespace abstand::ui {

/// One line of the legend: so long an arrow means so much.
struct ArrowScale {
  double metres{0.0};  ///< length of the longest arrow in sight; 0: none in sight
  double value{0.0};   ///< what it stands for: N, N m or m/s
};

class Arrows {
 public:
  explicit Arrows(vtkRenderer* renderer) : renderer_{renderer} {}

  void open(const view::SceneOutline& outline);
  /// Two forces on each object, each at the centre of its contact points (weighted by force): that of pairs
  /// whose surfaces touch (isTouching), and, thinner and in another colour, that of pairs that are only
  /// within their margins. Total torque about its centre of mass, velocity of its centre of mass. On each
  /// joint the torque about its axis, or the force along it, that the contacts of its robot cause. True when
  /// something looks different now.
  bool refresh(const view::SceneOutline& outline, const view::SceneSnapshot& snapshot,
               const ViewOptions& options);

  const ArrowScale& forceScale() const { return force_scale_[kReal]; }
  const ArrowScale& virtualScale() const { return force_scale_[kVirtual]; }
  const ArrowScale& torqueScale() const { return torque_; }
  const ArrowScale& jointTorqueScale() const { return joint_torque_; }
  const ArrowScale& jointForceScale() const { return joint_force_; }
  const ArrowScale& velocityScale() const { return velocity_; }

 private:
  enum Kind { kReal, kVirtual, kKinds };
  /// What all pairs of one kind do to an object.
  struct Push {
    Vector3d force{Vector3d::Zero()};
    Vector3d point{Vector3d::Zero()};  ///< the sum of weighted points at first
    double weight{0.0};
  };
  void addJoints(const view::SceneSnapshot& snapshot, const ViewOptions& options);
  void sumForces(const view::SceneOutline& outline, const view::SceneSnapshot& snapshot);

  vtkRenderer* renderer_;
  std::array<std::unique_ptr<ArrowBatch>, kKinds> forces_;
  std::unique_ptr<ArrowBatch> torques_, velocities_, joint_torques_, joint_forces_;
  std::array<std::vector<Push>, kKinds> pushes_;  // by object
  std::array<ArrowScale, kKinds> force_scale_;
  ArrowScale torque_, velocity_, joint_torque_, joint_force_;
};

}  // namespace abstand::ui
