// Numbers in JSON documents.
#pragma once

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

namespace abstand::cli {

/// null for infinite values and NaN, which JSON lacks.
inline nlohmann::ordered_json numberOrNull(double v) {
  return std::isfinite(v) ? nlohmann::ordered_json(v) : nlohmann::ordered_json(nullptr);
}

/// null also if there is no value.
inline nlohmann::ordered_json orNull(const std::optional<double>& v) {
  return v ? numberOrNull(*v) : nlohmann::ordered_json(nullptr);
}

}  // namespace abstand::cli
