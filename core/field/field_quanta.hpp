// Distances quantised to 16 bits. Internal to the engine.
#pragma once

#include <cmath>
#include <cstdint>

namespace abstand::field {

/// Largest distance of a field, in quanta.
inline constexpr float kMaxQuanta = 32766.0f;
/// Error of quantisation in half quanta, including the rounding of the division.
inline constexpr double kQuantized = 1.01;

/// Rounds to the nearest multiple of a quantum.
inline std::int16_t toQuanta(float value, float quantum) {
  const float quanta = value / quantum;
  return static_cast<std::int16_t>(quanta + std::copysign(0.5f, quanta));
}

}  // namespace abstand::field
