// Hash of numbers, to compare whole runs bit by bit.
#pragma once

#include <bit>
#include <cstdint>

namespace abstand {

/// FNV-1a over the bits of doubles; -0.0 counts as 0.0.
class StateHash {
 public:
  void add(double v) {
    if (v == 0.0) v = 0.0;
    auto bits = std::bit_cast<std::uint64_t>(v);
    for (int i = 0; i < 8; ++i, bits >>= 8) hash_ = (hash_ ^ (bits & 0xff)) * 0x100000001b3ull;
  }
  std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_{0xcbf29ce484222325ull};
};

}  // namespace abstand
