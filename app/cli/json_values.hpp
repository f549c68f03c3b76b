// Numbers in JSON documents.
#pragma once

#include <cmath>
#include <nlohmann/json.hpp>

namespace abstand::cli {

/// JSON has no infinity and no NaN: null.
inline nlohmann::ordered_json numberOrNull(double v) {
  return std::isfinite(v) ? nlohmann::ordered_json(v) : nlohmann::ordered_json(nullptr);
}

}  // namespace abstand::cli
