// Standard output, written with every error noticed.
#pragma once

#include <string_view>

namespace abstand {

/// Writes all of it at once. Throws WriteError, and Interrupted when a reader takes nothing after an
/// interrupt.
void writeStandardOutput(std::string_view text);

/// Opens /dev/null for reading in place of standard descriptors that are closed, so that no output file gets
/// their numbers and writing to them fails. Called once, first of all.
void reserveStandardDescriptors();

/// An output file goes to standard output, so that reports belong elsewhere.
void claimStandardOutput() noexcept;
bool isStandardOutputClaimed() noexcept;

}  // namespace abstand
