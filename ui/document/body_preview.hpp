// What a person will look like with other sizes, before the person is built.
#pragma once

#include <QString>
#include <functional>
#include <vector>

#include "core/math/transform.hpp"
#include "ui/document/work.hpp"

namespace abstand::ui {

/// A part of a standing body, arms down: an ellipsoid or a cuboid along the axes x (forward), y (left), z
/// (up).
struct BodyPatch {
  Vector3d centre, half;  ///< m; z = 0 is the floor; half extents
  bool box{false};
};

struct BodyShape {
  std::vector<BodyPatch> patches;
  double stature{0.0};  ///< m
  double mass{0.0};     ///< kg
};

struct BodyPreview {
  QString problem;              ///< why there is no such person; empty: there is one
  BodyShape person;             ///< without a problem
  BodyShape smallest, largest;  ///< woman of the 5th and man of the 95th percentile, for comparison
};

/// Previews the person of the scene with these options in place of the scene's. GUI thread; takes well below
/// a millisecond.
using BodyPreviewer = std::function<BodyPreview(const QString& person, const PersonOptions& options)>;

}  // namespace abstand::ui
