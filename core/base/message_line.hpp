// Text of errors and warnings, safe to print whatever a stranger's file put into it.
#pragma once

#include <string>
#include <string_view>

namespace abstand {

inline constexpr std::size_t kMaxMessageBytes = 1000;

/// One line: UTF-8 without control characters (C0, C1, line separators and marks of writing direction), at
/// most `max_bytes` long. Blanks of all kinds become spaces, other such characters and bytes that are no
/// UTF-8 appear as \x1b; of a longer text the middle is left out.
std::string messageLine(std::string_view text, std::size_t max_bytes = kMaxMessageBytes);

/// The same line by line, for text of several lines.
std::string messageLines(std::string_view text, std::size_t max_bytes_a_line);

}  // namespace abstand
