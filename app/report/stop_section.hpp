// Section of the margin report: the stops that the proposed margins would have caused.
#pragma once

#include <string>

#include "app/tune/tune_answer.hpp"

namespace abstand::report {

/// HTML: of each stop at its beginning the terms of the protective distance, the largest one named; and how
/// many stops each term has. Empty if no proposed margin stops the robot.
std::string stopSection(const tune::TuneAnswer& answer);

}  // namespace abstand::report
