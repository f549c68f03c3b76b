// Sanitises text of untrusted files for errors and warnings.
#pragma once

#include <string>
#include <string_view>

namespace abstand {

inline constexpr std::size_t kMaxMessageBytes = 1000;

/// One line: UTF-8 without control characters (C0, C1, line separators, bidirectional marks), at most
/// `max_bytes` long. All kinds of blanks become spaces; other such characters and bytes that are not UTF-8
/// are escaped as \x1b. The middle of a longer text is left out.
std::string messageLine(std::string_view text, std::size_t max_bytes = kMaxMessageBytes);

/// messageLine() applied to every line of a text.
std::string messageLines(std::string_view text, std::size_t max_bytes_a_line);

}  // namespace abstand
