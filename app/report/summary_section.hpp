// Section of a report: what it says, in a few lines.
#pragma once

#include <string>

#include "app/tune/tune_answer.hpp"

namespace abstand::report {

/// The nearest part, the largest proposed margin, contacts beyond limits, protective distances, and how much
/// there is behind them. Everything stands in a section of its own below.
std::string summarySection(const tune::TuneAnswer& answer);

}  // namespace abstand::report
