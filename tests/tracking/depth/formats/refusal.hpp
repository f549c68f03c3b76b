// What readers say of bytes that they refuse.
#pragma once

#include <string>

#include "core/base/error.hpp"

namespace abstand::testing {

/// The sentence of the ParseError that `read` throws.
template <class Read>
std::string refusal(const Read& read) {
  try {
    read();
  } catch (const ParseError& e) {
    return e.what();
  }
  return "nothing was refused";
}

inline bool holds(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

}  // namespace abstand::testing
