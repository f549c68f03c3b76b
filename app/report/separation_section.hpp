// Section of a report: protective distances.
#pragma once

#include <string>

#include "app/tune/tune_answer.hpp"

namespace abstand::report {

/// For each part how long its protective distance was violated, and of the worst moment every term of S_p
/// beside the certified clearance.
std::string separationSection(const tune::TuneAnswer& answer);

}  // namespace abstand::report
