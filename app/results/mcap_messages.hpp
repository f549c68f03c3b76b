// JSON messages of results, and their schemas. Internal to this module.
#pragma once

#include <string>

#include "app/tune/margin_events.hpp"
#include "app/tune/tune_answer.hpp"

namespace abstand::results {

/// JSON schemas in the subset of Foxglove: types `number`, `string`, `boolean`. Unknown numbers are omitted
/// from messages, as JSON has no infinity and Foxglove no null.
extern const char* const kClearanceSchema;
extern const char* const kApproachSchema;
extern const char* const kEventSchema;

/// Clearance of a part of the recording in a frame. `seen`: false if nothing is certified about it.
std::string clearanceMessage(const tune::TunedRecording& recording, const tune::PartClearance& part,
                             std::size_t frame);
std::string approachMessage(const tune::RankedApproach& ranked);
std::string eventMessage(const tune::MarginEvent& event);

}  // namespace abstand::results
