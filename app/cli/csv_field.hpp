// Text in a CSV file.
#pragma once

#include <string>

namespace abstand::cli {

/// Quotes a name if a CSV needs it.
inline std::string csvField(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

}  // namespace abstand::cli
