// Refusal of a calibration, with numbers.
#pragma once

#include <cstdio>

#include "core/base/error.hpp"

namespace abstand::tracking {

/// Throws UsageError with the text of a printf pattern, up to 299 characters.
template <class... Values>
[[noreturn]] void refuse(const char* pattern, Values... values) {
  char text[300];
  std::snprintf(text, sizeof text, pattern, values...);
  throw UsageError(text);
}

}  // namespace abstand::tracking
