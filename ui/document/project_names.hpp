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

/// A switch of the view.
struct ViewFlag {
  const char* name;
  bool ViewOptions::*member;
};
inline constexpr std::array<ViewFlag, 9> kViewFlags{{{"forces", &ViewOptions::forces},
                                                     {"torques", &ViewOptions::torques},
                                                     {"velocities", &ViewOptions::velocities},
                                                     {"closest_points", &ViewOptions::closest},
                                                     {"labels", &ViewOptions::labels},
                                                     {"floor", &ViewOptions::floor},
                                                     {"shadows", &ViewOptions::shadows},
                                                     {"auto_scale", &ViewOptions::auto_scale},
                                                     {"transparent_people", &ViewOptions::transparent}}};

}  // namespace abstand::ui
