// Messages of results and their JSON schemas. Internal to this module.
#pragma once

#include <string>

#include "app/tune/margin_events.hpp"
#include "app/tune/tune_answer.hpp"

namespace abstand::results {

/// JSON schemas as Foxglove reads them: types `number`, `string`, `boolean`; a field of a number that is not
/// known is left out of its message, as JSON has no infinity and Foxglove no null.
extern const char* const kClearanceSchema;
extern const char* const kApproachSchema;
extern const char* const kEventSchema;

/// Of a part in a frame. `seen`: false where nothing certain is known of its clearance.
std::string clearanceMessage(const tune::TunedRecording& recording, std::size_t part, std::size_t frame);
std::string approachMessage(const tune::RankedApproach& ranked);
std::string eventMessage(const tune::MarginEvent& event);

}  // namespace abstand::results
