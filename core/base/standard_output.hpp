// Standard output; every write error is reported.
#pragma once

#include <string_view>

namespace abstand {

/// Writes the whole text. Throws WriteError, and Interrupted if the reader accepts nothing after an
/// interrupt.
void writeStandardOutput(std::string_view text);

/// Opens /dev/null read-only in place of closed standard descriptors, so that no output file gets their
/// numbers and writing to them fails. Called once, before anything else.
void reserveStandardDescriptors();

/// Marks standard output as used by an output file, so that reports do not go there too.
void claimStandardOutput() noexcept;
bool isStandardOutputClaimed() noexcept;

}  // namespace abstand
