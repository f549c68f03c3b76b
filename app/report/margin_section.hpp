// Sections of the margin report: closest approaches, sets of margins, and variants of one recording.
#pragma once

#include <string>

#include "app/tune/tune_answer.hpp"

namespace abstand::report {

/// HTML: closest approach of each part, its error with all contributions, and the verdict.
std::string closestSection(const tune::TuneAnswer& answer);
/// HTML: minimum certified clearance of each part over all phases of program and recording; empty if it was
/// not asked for.
std::string worstPhaseSection(const tune::TuneAnswer& answer);
/// HTML: outcomes of uniform margins, and of margins by part, link and pair.
std::string marginSetSection(const tune::TuneAnswer& answer);
/// HTML; empty if no recording has several runs.
std::string bandSection(const tune::TuneAnswer& answer);

}  // namespace abstand::report
