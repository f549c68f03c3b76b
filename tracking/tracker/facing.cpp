#include "tracking/tracker/facing.hpp"

#include <cmath>

namespace abstand::tracking {

void Facing::decideLying(double turning, double searching) {
  if (std::isnan(searching)) searching = 1.0;
  lies = true;
  away = turning * searching < 1.0;
  const bool agree = searching != 1.0 && (searching < 1.0) == (turning < 1.0);
  if (!agree)
    ratio = 1.0;
  else
    ratio = std::abs(std::log(searching)) < std::abs(std::log(turning)) ? searching : turning;
}

}  // namespace abstand::tracking
