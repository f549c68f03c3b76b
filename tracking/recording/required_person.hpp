// Refuses recordings that move no part of a person.
#pragma once

#include <string>

#include "tracking/recording/recording.hpp"

namespace abstand::tracking {

/// Throws ParseError, with what to do as its hint, if no part of the body has both of its end joints. `file`
/// is its name in the message.
void requirePerson(const RecordingReport& report, const std::string& file);

}  // namespace abstand::tracking
