#include "core/margin/threshold_masks.hpp"

#include <algorithm>
#include <numeric>

#include "core/math/transform.hpp"

namespace abstand::margin {

ThresholdMasks::ThresholdMasks(std::span<const double> values) {
  std::array<std::uint8_t, kValues> order;
  const auto end = order.begin() + static_cast<std::ptrdiff_t>(values.size());
  std::iota(order.begin(), end, std::uint8_t{0});
  std::sort(order.begin(), end, [&](std::uint8_t a, std::uint8_t b) { return values[a] < values[b]; });
  sorted_.fill(kInfinity);
  lowest_.fill(0);
  for (std::size_t k = 0; k < values.size(); ++k) {
    sorted_[k] = values[order[k]];
    lowest_[k + 1] = lowest_[k] | std::uint64_t{1} << order[k];
  }
}

std::uint64_t ThresholdMasks::below(double threshold) const {
  // Without branches: thresholds come in no order.
  std::size_t count = 0;
  for (std::size_t step = kValues / 2; step > 0; step /= 2)
    count += sorted_[count + step - 1] < threshold ? step : 0;
  count += sorted_[count] < threshold ? 1 : 0;
  return lowest_[count];
}

}  // namespace abstand::margin
