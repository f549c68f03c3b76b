// Which values of a list lie below a threshold, for many thresholds.
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace abstand::margin {

/// Up to 64 values, sorted, with the set of the lowest k of them for each k: a threshold costs one binary
/// search instead of a comparison with each value.
class ThresholdMasks {
 public:
  ThresholdMasks() = default;
  /// At most 64 values, none of them NaN.
  explicit ThresholdMasks(std::span<const double> values);

  /// Bit i: value i is below `threshold`.
  std::uint64_t below(double threshold) const;

 private:
  static constexpr std::size_t kValues = 64;
  std::array<double, kValues> sorted_;             ///< +infinity behind the last value
  std::array<std::uint64_t, kValues + 1> lowest_;  ///< of the lowest k values
};

}  // namespace abstand::margin
