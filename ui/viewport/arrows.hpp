// Forces, torques and velocities of all objects as arrows. VTK: .cpp files only.
#pragma once

#include <vtkRenderer.h>

#include <memory>

#include "core/scene/snapshot.hpp"
#include "ui/viewport/arrow_batch.hpp"
#include "ui/viewport/view_options.hpp"

namespace abstand::ui {

/// One line of the legend: so long an arrow means so much.
struct ArrowScale {
  double metres{0.0};  ///< length of the longest arrow in sight; 0: none in sight
  double value{0.0};   ///< what it stands for: N, N m or m/s
};

class Arrows {
 public:
  explicit Arrows(vtkRenderer* renderer) : renderer_{renderer} {}

  void open(const SceneOutline& outline);
  /// Total contact force on each object at the centre of its contact points (weighted by force), total torque
  /// about its centre of mass, velocity of its centre of mass. True when something looks different now.
  bool refresh(const SceneOutline& outline, const SceneSnapshot& snapshot, const ViewOptions& options);

  const ArrowScale& forceScale() const { return force_; }
  const ArrowScale& torqueScale() const { return torque_; }
  const ArrowScale& velocityScale() const { return velocity_; }

 private:
  void findContactPoints(const SceneOutline& outline, const SceneSnapshot& snapshot);

  vtkRenderer* renderer_;
  std::unique_ptr<ArrowBatch> forces_, torques_, velocities_;
  std::vector<Vector3d> contact_points_;  // by object; the sum of weighted points at first
  std::vector<double> weights_;
  ArrowScale force_, torque_, velocity_;
};

}  // namespace abstand::ui
