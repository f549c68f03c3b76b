// What the viewport shows.
#pragma once

namespace abstand::ui {

struct ViewOptions {
  bool forces{true};
  bool torques{true};
  bool joint_torques{false};
  bool velocities{false};
  bool closest{true};
  bool labels{true};
  bool floor{true};
  bool shadows{true};
  /// Longest arrow of a kind has a fixed length in the scene; otherwise the lengths below hold.
  bool auto_scale{true};
  /// People are drawn with the opacity below, else solid.
  bool transparent{true};
  double human_opacity{0.7};

  double metres_per_newton{0.002};
  double metres_per_newton_metre{0.01};
  double metres_per_metre_per_second{0.25};
  /// Smaller ones are not drawn: they would be dots.
  double min_force{0.5};    ///< N
  double min_torque{0.05};  ///< N m
  double min_speed{0.02};   ///< m/s

  /// Opacity with which people are drawn, 0 to 1.
  double shownOpacity() const { return transparent ? human_opacity : 1.0; }
  bool operator==(const ViewOptions&) const = default;
};

enum class CameraPreset { kFront, kSide, kTop, kIso };

}  // namespace abstand::ui
