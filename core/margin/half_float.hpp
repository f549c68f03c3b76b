// Numbers of two bytes that err on a chosen side.
#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace abstand::margin {

/// IEEE 754 binary16: 11 significant bits, so a length of 100 mm is kept within 0.07 mm. Infinities stay.
using HalfBits = std::uint16_t;

inline double fromHalf(HalfBits bits) {
  return static_cast<double>(static_cast<float>(Eigen::numext::bit_cast<Eigen::half>(bits)));
}

/// The largest half that is not above `value`; -infinity for what is not a number.
inline HalfBits halfBelow(double value) {
  if (!(value == value)) return 0xfc00;
  const auto nearest = Eigen::numext::bit_cast<HalfBits>(Eigen::half(static_cast<float>(value)));
  if (!(fromHalf(nearest) > value)) return nearest;
  if (nearest == 0) return 0x8001;
  return static_cast<HalfBits>(nearest & 0x8000 ? nearest + 1 : nearest - 1);
}

/// The smallest half that is not below `value`; +infinity for what is not a number.
inline HalfBits halfAbove(double value) { return static_cast<HalfBits>(halfBelow(-value) ^ 0x8000); }

}  // namespace abstand::margin
