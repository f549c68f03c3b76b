// The camera.
#include "ui/viewport/camera.hpp"

#include <vtkCamera.h>
#include <vtkMatrix4x4.h>

#include <algorithm>
#include <cmath>

namespace abstand::ui {

namespace {

constexpr double kViewAngle = 32.0;                   // degrees, vertical
constexpr double kOrbitPerPixel = 0.0075;             // rad
constexpr double kSteepest = 0.5 * kPi - 1e-3;        // rad; at the pole "up" would be lost
constexpr double kNearest = 0.05, kFarthest = 200.0;  // m
constexpr double kRoom = 1.02;                        // around a fitted box

}  // namespace

Camera::Camera(vtkRenderer* renderer) : renderer_{renderer} {
  renderer_->GetActiveCamera()->SetViewAngle(kViewAngle);
  place(focus_, distance_);
}

Vector3d Camera::back() const {
  return {std::cos(elevation_) * std::cos(azimuth_), std::cos(elevation_) * std::sin(azimuth_),
          std::sin(elevation_)};
}

void Camera::place(const Vector3d& focus, double distance) {
  focus_ = focus;
  distance_ = std::clamp(distance, kNearest, kFarthest);
  const Vector3d eye = focus_ + distance_ * back();
  // Seen from above, up is where the azimuth points away from.
  const Vector3d away(-std::sin(elevation_) * std::cos(azimuth_), -std::sin(elevation_) * std::sin(azimuth_),
                      std::cos(elevation_));
  vtkCamera* camera = renderer_->GetActiveCamera();
  camera->SetPosition(eye.data());
  camera->SetFocalPoint(focus_.data());
  camera->SetViewUp(away.data());
}

void Camera::orbit(double dx, double dy) {
  azimuth_ -= kOrbitPerPixel * dx;
  elevation_ = std::clamp(elevation_ + kOrbitPerPixel * dy, -kSteepest, kSteepest);
  place(focus_, distance_);
}

void Camera::pan(double dx, double dy) {
  update();
  const double per_pixel =
      2.0 * distance_ * std::tan(0.5 * unit::deg(kViewAngle)) / std::max(1.0, size_.height());
  place(focus_ + per_pixel * (-dx * R_CW_.row(0) + dy * R_CW_.row(1)).transpose(), distance_);
}

void Camera::setView(const CameraView& view) {
  azimuth_ = view.azimuth;
  elevation_ = std::clamp(view.elevation, -kSteepest, kSteepest);
  place(view.focus, view.distance);
}

void Camera::zoom(double factor) { place(focus_, distance_ * factor); }

void Camera::look(CameraPreset preset, const geometry::Bounds& box) {
  switch (preset) {
    case CameraPreset::kFront:
      azimuth_ = 0.0, elevation_ = 0.08;
      break;
    case CameraPreset::kSide:
      azimuth_ = -0.5 * kPi, elevation_ = 0.08;
      break;
    case CameraPreset::kTop:
      azimuth_ = -0.5 * kPi, elevation_ = kSteepest;
      break;
    case CameraPreset::kIso:
      azimuth_ = -0.25 * kPi, elevation_ = unit::deg(24.0);
      break;
  }
  place(focus_, distance_);
  fit(box);
}

void Camera::fit(const geometry::Bounds& box) {
  if (!(box.upper.x() >= box.lower.x())) return;
  place(box.centre(), distance_);
  update();
  const double tan_v = std::tan(0.5 * unit::deg(kViewAngle));
  const double tan_h = tan_v * size_.width() / std::max(1.0, size_.height());
  double needed = kNearest;
  for (int corner = 0; corner < 8; ++corner) {
    const Vector3d half = 0.5 * kRoom * box.extent();
    const Vector3d c = R_CW_ * Vector3d(corner & 1 ? half.x() : -half.x(), corner & 2 ? half.y() : -half.y(),
                                        corner & 4 ? half.z() : -half.z());
    needed = std::max({needed, c.z() + std::abs(c.x()) / tan_h, c.z() + std::abs(c.y()) / tan_v});
  }
  place(box.centre(), needed);
}

void Camera::update() {
  vtkCamera* camera = renderer_->GetActiveCamera();
  const double aspect = size_.width() / std::max(1.0, size_.height());
  vtkMatrix4x4* clip = camera->GetCompositeProjectionTransformMatrix(aspect, -1.0, 1.0);
  vtkMatrix4x4* view = camera->GetModelViewTransformMatrix();
  for (int r = 0; r < 4; ++r)
    for (int c = 0; c < 4; ++c) {
      clip_from_world_(r, c) = clip->GetElement(r, c);
      if (r < 3 && c < 3) R_CW_(r, c) = view->GetElement(r, c);
    }
}

QPointF Camera::project(const Vector3d& p_W, double* depth) const {
  const Eigen::Vector4d clip = clip_from_world_ * p_W.homogeneous();
  if (depth) *depth = clip.w();
  const double w = std::abs(clip.w()) > 1e-9 ? clip.w() : 1e-9;
  return {0.5 * (1.0 + clip.x() / w) * size_.width(), 0.5 * (1.0 - clip.y() / w) * size_.height()};
}

Vector3d Camera::atDepthOf(const Vector3d& p_W, const QPointF& on_screen) const {
  const Eigen::Vector4d clip = clip_from_world_ * p_W.homogeneous();
  // Equal depths of a perspective picture are equal depths before the camera.
  const Eigen::Vector4d wanted(2.0 * on_screen.x() / size_.width() - 1.0,
                               1.0 - 2.0 * on_screen.y() / size_.height(), clip.z() / clip.w(), 1.0);
  return Eigen::Vector4d(clip_from_world_.inverse() * wanted).hnormalized();
}

Vector3d Camera::fromScreen(const Vector3d& direction) const {
  return R_CW_.transpose() * Vector3d(direction.x(), -direction.y(), direction.z());
}

Vector3d Camera::onScreen(const Vector3d& direction_W) const {
  const Vector3d c = R_CW_ * direction_W;
  return {c.x(), -c.y(), c.z()};
}

}  // namespace abstand::ui
