// Parts of the report on margins: how near people came, sets of margins, and one recording as several people.
#pragma once

#include <string>

#include "app/tune/tune_answer.hpp"

namespace abstand::report {

/// HTML: of each part the closest approach, its error with each share, and the verdict.
std::string closestSection(const tune::TuneAnswer& answer);
/// HTML: what uniform margins, and margins by part, link and pair would have done.
std::string marginSetSection(const tune::TuneAnswer& answer);
/// HTML; empty where no recording has several runs.
std::string bandSection(const tune::TuneAnswer& answer);

}  // namespace abstand::report
