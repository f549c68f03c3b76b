// The camera: orbit with z up, pan, zoom, presets, fit. VTK: .cpp files only.
#pragma once

#include <vtkRenderer.h>

#include <QPointF>
#include <QSizeF>

#include "core/geometry/triangle_mesh.hpp"
#include "ui/document/camera_view.hpp"
#include "ui/document/view_options.hpp"

namespace abstand::ui {

/// All lengths on the screen in logical pixels.
class Camera {
 public:
  explicit Camera(vtkRenderer* renderer);

  void setViewSize(const QSizeF& size) { size_ = size; }
  void orbit(double dx, double dy);
  void pan(double dx, double dy);
  /// Distance times `factor`.
  void zoom(double factor);
  /// Looks from the preset's side at the box.
  void look(CameraPreset preset, const geometry::Bounds& box);
  /// Keeps the direction and brings the box into sight.
  void fit(const geometry::Bounds& box);

  CameraView view() const { return {focus_, distance_, azimuth_, elevation_}; }
  /// Values out of range are clamped.
  void setView(const CameraView& view);

  /// Where a point is on the screen, from the upper left corner; depth > 0 before the camera.
  QPointF project(const Vector3d& p_W, double* depth = nullptr) const;
  /// The point under a place of the screen that is as far before the camera as `p_W`.
  Vector3d atDepthOf(const Vector3d& p_W, const QPointF& on_screen) const;
  /// World direction as seen on the screen (x right, y down, z towards the eye).
  Vector3d onScreen(const Vector3d& direction_W) const;
  /// World direction of one on the screen (x right, y down, z towards the eye).
  Vector3d fromScreen(const Vector3d& direction) const;
  /// To be called before a number of the four functions above.
  void update();

 private:
  void place(const Vector3d& focus, double distance);
  Vector3d back() const;

  vtkRenderer* renderer_;
  QSizeF size_{800.0, 600.0};
  Vector3d focus_{0.0, 0.0, 1.0};
  double distance_{4.0};
  double azimuth_{-0.9}, elevation_{0.4};  // rad; of the direction from the focus to the eye
  Eigen::Matrix4d clip_from_world_{Eigen::Matrix4d::Identity()};
  Matrix3d R_CW_{Matrix3d::Identity()};
};

}  // namespace abstand::ui
