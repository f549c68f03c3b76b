// Handles in the 3D view that move and turn a body.
#pragma once

#include <QPointF>
#include <array>
#include <optional>
#include <vector>

#include "core/math/transform.hpp"

namespace abstand::ui {

class Camera;

/// How far a handle was pulled: a shift (m, world) and a turn (rad) about the vertical through the centre.
struct HandlePull {
  Vector3d shift{Vector3d::Zero()};
  double turn{0.0};
};

/// Three arrows along the axes of the world and a horizontal ring about a point, of one size on the screen.
/// Lengths on the screen in logical pixels. Camera::update() comes first.
class Handles {
 public:
  static constexpr double kLength = 84.0;       ///< px, of an arrow that is seen from the side
  static constexpr double kRing = 62.0;         ///< px, its radius seen from above
  static constexpr double kReach = 8.0;         ///< px from a handle that still take hold of it
  static constexpr double kStep = 1e-3;         ///< m, of a shift
  static constexpr double kTurn = kPi / 180.0;  ///< rad, of a turn

  enum class Part { kX, kY, kZ, kTurn };

  /// Where they are, for drawing. The ring is empty where it is seen from the side.
  struct Drawing {
    QPointF centre;
    std::array<QPointF, 3> tips;
    std::vector<QPointF> ring;
    std::optional<Part> held;
  };
  /// nullopt: behind the camera.
  std::optional<Drawing> drawing(const Camera& camera, const Vector3d& centre_W) const;

  /// The handle under a place of the screen; it is held until release().
  bool grab(const Camera& camera, const Vector3d& centre_W, const QPointF& at);
  bool isHeld() const { return held_.has_value(); }
  /// From where it was grabbed, in steps of kStep and kTurn.
  HandlePull pull(const Camera& camera, const QPointF& at) const;
  void release() { held_.reset(); }

 private:
  struct Held {
    Part part;
    Vector3d centre_W;
    QPointF from;
  };
  std::optional<Held> held_;
};

}  // namespace abstand::ui
