// Random numbers that are the same on every machine and for any number of threads.
#pragma once

#include <cmath>
#include <cstdint>

#include "core/math/transform.hpp"

namespace abstand {

/// A separate stream for each pair (seed, index): splitmix64 (Steele, Lea, Flood 2014).
class Random {
 public:
  Random(std::uint64_t seed, std::uint64_t index)
      : state_{seed * 0x9e3779b97f4a7c15ull ^ (index + 1) * 0xd1b54a32d192ed03ull} {}

  std::uint64_t bits() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15ull;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
    return z ^ (z >> 31);
  }
  /// Uniform in [0, 1).
  double unit() { return static_cast<double>(bits() >> 11) * 0x1.0p-53; }
  double between(double lower, double upper) { return lower + (upper - lower) * unit(); }
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(bits() % count); }
  bool chance(double part) { return unit() < part; }

  Vector3d inCube(double reach) {
    const double x = between(-reach, reach), y = between(-reach, reach);
    return {x, y, between(-reach, reach)};
  }
  Vector3d direction() {
    const double z = between(-1.0, 1.0), a = between(0.0, 2.0 * kPi), r = std::sqrt(1.0 - z * z);
    return {r * std::cos(a), r * std::sin(a), z};
  }
  /// Uniformly distributed rotation (Shoemake 1992).
  Matrix3d rotation() {
    const double u = unit(), v = between(0.0, 2.0 * kPi), w = between(0.0, 2.0 * kPi);
    const double a = std::sqrt(1.0 - u), b = std::sqrt(u);
    return Quaterniond(b * std::cos(w), a * std::sin(v), a * std::cos(v), b * std::sin(w)).toRotationMatrix();
  }

 private:
  std::uint64_t state_;
};

}  // namespace abstand
