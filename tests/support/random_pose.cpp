#include "tests/support/random_pose.hpp"

#include <cmath>

namespace abstand::testing {

double randomUnit(std::uint64_t seed, std::uint64_t stream) {
  // splitmix64 (Steele, Lea, Flood 2014)
  std::uint64_t z = seed * 0x9e3779b97f4a7c15ull + stream * 0xd1b54a32d192ed03ull + 0x9e3779b97f4a7c15ull;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
  z ^= z >> 31;
  return static_cast<double>(z >> 11) * 0x1.0p-53;
}

Transform randomPose(std::uint64_t seed, double reach) {
  // uniform rotation (Shoemake 1992)
  const double u1 = randomUnit(seed, 1), u2 = 2 * kPi * randomUnit(seed, 2),
               u3 = 2 * kPi * randomUnit(seed, 3);
  const double a = std::sqrt(1 - u1), b = std::sqrt(u1);
  Transform X = Transform::Identity();
  X.linear() =
      Quaterniond(b * std::cos(u3), a * std::sin(u2), a * std::cos(u2), b * std::sin(u3)).toRotationMatrix();
  for (int i = 0; i < 3; ++i) X.translation()[i] = reach * (2 * randomUnit(seed, 10 + i) - 1);
  return X;
}

}  // namespace abstand::testing
