// What the tour of the window shows.
#pragma once

#include "ui/panels/tour.hpp"

namespace abstand::ui {

class DockSet;

std::vector<Tour::Step> tourSteps(const DockSet& docks);

}  // namespace abstand::ui
