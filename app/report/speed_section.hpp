// Sections of the margin report on permitted speeds, and on the trade-off of margin, speed and time.
#pragma once

#include <string>

#include "app/tune/tune_answer.hpp"

namespace abstand::report {

/// HTML: the permitted speed of each segment of the program, and the result of the replay that proves a speed
/// profile, if one was requested. Empty without segments.
std::string speedSection(const tune::TuneAnswer& answer);
/// HTML: margin and cycle time of the program at several constant paces. Empty if none were requested.
std::string tradeSection(const tune::TuneAnswer& answer);

}  // namespace abstand::report
