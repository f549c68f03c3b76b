// Small pieces of text for messages and comparisons, the same in every locale.
#pragma once

#include <string>
#include <string_view>

namespace abstand::text {

/// Letters a to z made small; everything else as it is.
std::string lowerCase(std::string_view text);

/// Without those characters of `blank` that stand at its ends.
std::string_view trimmed(std::string_view text, std::string_view blank = " \t");
/// Without `leading` characters at its beginning and `trailing` ones at its end.
std::string_view trimmed(std::string_view text, std::string_view leading, std::string_view trailing);

/// A found piece of text for an error message: in single quotes, at most 40 characters, nothing unprintable.
std::string inQuotes(std::string_view found);
/// The same in double quotes, as messages about mesh and robot files have it; `nothing` for an empty text.
std::string inDoubleQuotes(std::string_view found);

/// A number with that many digits after the point, for reading by people.
std::string rounded(double value, int digits);

}  // namespace abstand::text
