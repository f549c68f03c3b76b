// Names in project files, for their reader and their writer.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/view/snapshot.hpp"
#include "ui/document/view_options.hpp"

namespace abstand::ui {

inline constexpr int kProjectVersion = 1;
inline constexpr char kVersionKey[] = "abstand_project";
inline constexpr double kMaxMargin = 2.0;  ///< m

/// The names of PairGroupState, in its order.
inline const std::vector<std::string> kGroupStates{"running", "paused", "stopped"};

/// A number without a limit, above or below.
inline constexpr char kUnlimited[] = "inf", kUnlimitedBelow[] = "-inf";

/// A switch of the view.
struct ViewFlag {
  const char* name;
  bool ViewOptions::*member;
};
/// A number of the view, and its name in a project file; left out where it is the usual one.
struct ViewNumber {
  const char* name;
  double ViewOptions::*member;
};
inline constexpr std::array<ViewNumber, 6> kViewNumbers{
    {{"metres_per_newton", &ViewOptions::metres_per_newton},
     {"metres_per_newton_metre", &ViewOptions::metres_per_newton_metre},
     {"metres_per_metre_per_second", &ViewOptions::metres_per_metre_per_second},
     {"least_force", &ViewOptions::min_force},
     {"least_torque", &ViewOptions::min_torque},
     {"least_speed", &ViewOptions::min_speed}}};

inline constexpr std::array<ViewFlag, 10> kViewFlags{{{"forces", &ViewOptions::forces},
                                                      {"torques", &ViewOptions::torques},
                                                      {"joint_torques", &ViewOptions::joint_torques},
                                                      {"velocities", &ViewOptions::velocities},
                                                      {"closest_points", &ViewOptions::closest},
                                                      {"labels", &ViewOptions::labels},
                                                      {"floor", &ViewOptions::floor},
                                                      {"shadows", &ViewOptions::shadows},
                                                      {"auto_scale", &ViewOptions::auto_scale},
                                                      {"transparent_people", &ViewOptions::transparent}}};

}  // namespace abstand::ui
