// Parts of the margin report on predicted contacts and their limits.
#pragma once

#include <string>
#include <vector>

#include "app/tune/tune_answer.hpp"

namespace abstand::report {

/// HTML section: for each part, how long a contact would have exceeded a limit, and the hardest one. Empty if
/// contacts were not judged.
std::string contactTimeSection(const tune::TuneAnswer& answer);

/// HTML table: force, energy and pressure of the contact of each approach beside their limits, with the
/// masses and the spring constant that they follow from; numbered from 1 as the approaches. Empty if none of
/// them has a contact.
std::string contactTable(const tune::TuneAnswer& answer, const std::vector<tune::RankedApproach>& approaches);

/// HTML table of the limits of the regions that occur in any contact, each number with its source. Empty if
/// there are none.
std::string limitTable(const tune::TuneAnswer& answer);

}  // namespace abstand::report
