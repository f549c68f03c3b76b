// The field of view of a planned depth camera. VTK: .cpp files only.
#pragma once

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>

#include "core/math/transform.hpp"
#include "ui/model/coverage_report.hpp"

namespace abstand::ui {

/// Lines: from the eye to the corners of the image at the nearest depth, and between the corners there and at
/// the farthest depth. Bodies hide them.
class SensorActor {
 public:
  explicit SensorActor(vtkRenderer* renderer);

  /// `X_W`: optical frame (x right, y down, z forward) in the world.
  void show(const Transform& X_W, const SensorKind& kind);
  void hide();
  bool shown() const { return actor_->GetVisibility() != 0; }
  /// Corners of what is drawn, m, world: those at the nearest depth, then those at the farthest one, each
  /// from the upper left clockwise in the image.
  std::array<Vector3d, 8> corners() const { return corners_; }

 private:
  vtkNew<vtkPolyData> data_;
  vtkNew<vtkActor> actor_;
  std::array<Vector3d, 8> corners_{};
};

}  // namespace abstand::ui
