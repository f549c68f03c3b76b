// Text helpers for messages and comparisons, independent of the locale.
#pragma once

#include <string>
#include <string_view>

namespace abstand::text {

/// Converts A to Z to lower case; everything else is unchanged.
std::string lowerCase(std::string_view text);

/// The text without characters of `blank` at either end.
std::string_view trimmed(std::string_view text, std::string_view blank = " \t");
/// The text without characters of `leading` at its start and of `trailing` at its end.
std::string_view trimmed(std::string_view text, std::string_view leading, std::string_view trailing);

/// Quotes text of an input for an error message: single quotes, at most 40 characters of UTF-8. Control
/// characters and bytes that are not UTF-8 become '?'.
std::string inQuotes(std::string_view found);
/// The same in double quotes, as in messages about mesh and robot files; `nothing` for an empty text.
std::string inDoubleQuotes(std::string_view found);

/// The number with `digits` digits after the point.
std::string rounded(double value, int digits);

}  // namespace abstand::text
