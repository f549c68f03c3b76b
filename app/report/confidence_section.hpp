// Section of the margin report: what the recordings say of recordings that nobody has made.
#pragma once

#include <string>

#include "app/tune/tune_answer.hpp"

namespace abstand::report {

/// HTML: upper confidence limits of the shares of unseen recordings and of unseen minutes that violate a
/// proposed margin, with their models, and the extreme values of the recordings beside the fitted
/// distribution.
std::string confidenceSection(const tune::TuneAnswer& answer);

}  // namespace abstand::report
