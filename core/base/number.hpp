// Numbers in text, independent of the locale; values that are not finite are rejected.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace abstand {

/// The whole of `text` as a finite double ("1", "-.5", "+2e-3"); nullopt for anything else,
/// nan, inf, hexadecimal and trailing characters included.
std::optional<double> parseDouble(std::string_view text);

/// The whole of `text` as a decimal integer that fits an int; nullopt for anything else.
std::optional<int> parseInt(std::string_view text);

/// Shortest text that reads back as the same double; "nan", "inf", "-inf" for those.
std::string formatDouble(double value);

}  // namespace abstand
