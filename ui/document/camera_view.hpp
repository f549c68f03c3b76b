// Where the camera of the 3D view stands.
#pragma once

#include "core/math/transform.hpp"

namespace abstand::ui {

/// The camera orbits about a focus, with z up.
struct CameraView {
  Vector3d focus{0.0, 0.0, 1.0};  ///< m, world
  double distance{4.0};           ///< m, from the focus to the eye; greater than 0
  double azimuth{-0.9};           ///< rad, of the direction from the focus to the eye
  double elevation{0.4};          ///< rad, likewise, above the horizon

  bool operator==(const CameraView& other) const {
    return focus == other.focus && distance == other.distance && azimuth == other.azimuth &&
           elevation == other.elevation;
  }
};

}  // namespace abstand::ui
