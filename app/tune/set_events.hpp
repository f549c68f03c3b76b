// What happened at a set of margins, one event after the other.
#pragma once

#include "app/tune/margin_events.hpp"
#include "app/tune/margin_rules.hpp"

namespace abstand::tune {

/// The stops of the robot under a set of margins for parts, links and pairs, all of them together, in order
/// of time; and the touches between frames that none of the margins would have told. Counts as
/// strategyOutcomes() does, from the first frame on from which every part can be judged. The recording's
/// result file is read (TunedRecording::file). Throws as strategyOutcomes().
std::vector<MarginEvent> setEvents(const TunedRecording& recording, const MarginRules& rules,
                                   const margin::MarginOptions& options);

}  // namespace abstand::tune
