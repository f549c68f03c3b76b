// Small pieces of text for messages and comparisons, the same in every locale.
#pragma once

#include <string>
#include <string_view>

namespace abstand::text {

/// Letters a to z made small; everything else as it is.
std::string lowerCase(std::string_view text);

/// A found piece of text for an error message: quoted, at most 40 characters, nothing unprintable.
std::string inQuotes(std::string_view found);

/// A number with that many digits after the point, for reading by people.
std::string rounded(double value, int digits);

}  // namespace abstand::text
