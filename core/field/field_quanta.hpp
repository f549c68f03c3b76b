// Distances kept in 16 bits. Internal to the engine.
#pragma once

namespace abstand::field {

/// Quanta of the largest distance of a field.
inline constexpr float kMaxQuanta = 32766.0f;
/// Of half a quantum: what rounding to quanta errs by, the rounding of the division included.
inline constexpr double kQuantized = 1.01;

}  // namespace abstand::field
