// Distances kept in 16 bits. Internal to the engine.
#pragma once

#include <cmath>
#include <cstdint>

namespace abstand::field {

/// Quanta of the largest distance of a field.
inline constexpr float kMaxQuanta = 32766.0f;
/// Of half a quantum: what rounding to quanta errs by, the rounding of the division included.
inline constexpr double kQuantized = 1.01;

/// The nearest multiple of a quantum.
inline std::int16_t toQuanta(float value, float quantum) {
  const float quanta = value / quantum;
  return static_cast<std::int16_t>(quanta + std::copysign(0.5f, quanta));
}

}  // namespace abstand::field
