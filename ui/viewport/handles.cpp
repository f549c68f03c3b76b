#include "ui/viewport/handles.hpp"

#include <algorithm>
#include <cmath>

#include "ui/viewport/camera.hpp"

namespace abstand::ui {

namespace {

constexpr int kRingPoints = 48;
constexpr double kShortArrow = 14.0;  // px: one that points at the viewer cannot be pulled
constexpr double kFlatRing = 0.12;    // of its area seen from above: likewise

/// px per metre along each axis of the world, about a point.
struct Scale {
  std::array<QPointF, 3> axes;
  double across;  ///< of a length that is seen from the side
};

QPointF onScreenOf(const Camera& camera, const Vector3d& centre_W, const Vector3d& v) {
  return camera.project(centre_W + v) - camera.project(centre_W);
}

Scale scaleAt(const Camera& camera, const Vector3d& centre_W) {
  constexpr double kShort = 0.01;  // m: so near the point, the picture is about linear
  const QPointF right = onScreenOf(camera, centre_W, kShort * camera.fromScreen(Vector3d::UnitX()));
  Scale scale{{}, std::hypot(right.x(), right.y()) / kShort};
  for (int k = 0; k < 3; ++k)
    scale.axes[static_cast<std::size_t>(k)] =
        onScreenOf(camera, centre_W, kShort * Vector3d::Unit(k)) / kShort;
  return scale;
}

double dot(const QPointF& a, const QPointF& b) { return a.x() * b.x() + a.y() * b.y(); }
double cross(const QPointF& a, const QPointF& b) { return a.x() * b.y() - a.y() * b.x(); }

double distanceToLine(const QPointF& p, const QPointF& a, const QPointF& b) {
  const QPointF d = b - a;
  const double length = dot(d, d);
  const double u = length > 0.0 ? std::clamp(dot(p - a, d) / length, 0.0, 1.0) : 0.0;
  const QPointF off = p - a - u * d;
  return std::hypot(off.x(), off.y());
}

/// rad, of a place of the screen about the centre of the ring, counted from x to y.
double angleAt(const Scale& scale, const QPointF& from_centre) {
  const double area = cross(scale.axes[0], scale.axes[1]);
  return std::atan2(cross(scale.axes[0], from_centre) / area, cross(from_centre, scale.axes[1]) / area);
}

double inSteps(double value, double step) { return std::round(value / step) * step; }

}  // namespace

std::optional<Handles::Drawing> Handles::drawing(const Camera& camera, const Vector3d& centre_W) const {
  double depth = 0.0;
  Drawing shown{camera.project(centre_W, &depth), {}, {}, {}};
  if (!centre_W.allFinite() || depth <= 0.0) return {};
  const Scale scale = scaleAt(camera, centre_W);
  if (!(scale.across > 0.0)) return {};
  for (std::size_t k = 0; k < 3; ++k) shown.tips[k] = shown.centre + kLength / scale.across * scale.axes[k];
  const double area = std::abs(cross(scale.axes[0], scale.axes[1])) / (scale.across * scale.across);
  for (int i = 0; area > kFlatRing && i <= kRingPoints; ++i) {
    const double angle = 2.0 * kPi * i / kRingPoints;
    shown.ring.push_back(shown.centre +
                         kRing / scale.across *
                             (std::cos(angle) * scale.axes[0] + std::sin(angle) * scale.axes[1]));
  }
  if (held_) shown.held = held_->part;
  return shown;
}

bool Handles::grab(const Camera& camera, const Vector3d& centre_W, const QPointF& at) {
  held_.reset();
  const std::optional<Drawing> shown = drawing(camera, centre_W);
  if (!shown) return false;
  double nearest = kReach;
  const auto offer = [&](Part part, double distance) {
    if (distance > nearest) return;
    nearest = distance;
    held_ = {part, centre_W, at};
  };
  for (std::size_t i = 1; i < shown->ring.size(); ++i)
    offer(Part::kTurn, distanceToLine(at, shown->ring[i - 1], shown->ring[i]));
  for (std::size_t k = 0; k < 3; ++k) {
    const QPointF arrow = shown->tips[k] - shown->centre;
    if (std::hypot(arrow.x(), arrow.y()) < kShortArrow) continue;
    offer(static_cast<Part>(k), distanceToLine(at, shown->centre + 0.2 * arrow, shown->tips[k]));
  }
  return isHeld();
}

HandlePull Handles::pull(const Camera& camera, const QPointF& at) const {
  HandlePull pull;
  if (!held_) return pull;
  const Scale scale = scaleAt(camera, held_->centre_W);
  if (held_->part == Part::kTurn) {
    const QPointF centre = camera.project(held_->centre_W);
    const double turn = angleAt(scale, at - centre) - angleAt(scale, held_->from - centre);
    pull.turn = inSteps(std::remainder(turn, 2.0 * kPi), kTurn);
    return pull;
  }
  const int axis = static_cast<int>(held_->part);
  const QPointF& along = scale.axes[static_cast<std::size_t>(axis)];
  const double length = dot(along, along);
  if (length > 0.0) pull.shift[axis] = inSteps(dot(at - held_->from, along) / length, kStep);
  return pull;
}

}  // namespace abstand::ui
