// Sections of a report: what was assumed, inputs, reservations.
#pragma once

#include <string>

#include "app/tune/tune_answer.hpp"

namespace abstand::report {

/// Every assumption with its value, who said it, and what a change of it does; the inputs with their content
/// hashes, the bodies of the people; the reservations.
std::string assumptionSection(const tune::TuneAnswer& answer);

}  // namespace abstand::report
