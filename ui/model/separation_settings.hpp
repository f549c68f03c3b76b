// What speed and separation are judged with.
#pragma once

#include "core/safety/protective_distance.hpp"

namespace abstand::ui {

/// Part of the document.
struct SeparationSettings {
  safety::SeparationOptions options;
  /// kg, effective mass of the robot in a contact; 0: not known, then it counts as immovable.
  double robot_mass{0.0};
  bool clamped{false};  ///< body parts cannot recoil: quasi-static contact

  bool operator==(const SeparationSettings& other) const;
};

}  // namespace abstand::ui
