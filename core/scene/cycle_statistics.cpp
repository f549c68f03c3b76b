#include "core/scene/cycle_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/error.hpp"
#include "core/base/number.hpp"

namespace abstand::scene {
namespace {

constexpr double kShortest = 10e-9;  // s
constexpr double kLongest = 100.0;   // s
constexpr double kGrowth = 1.01;

std::size_t binOf(double seconds) {
  const double clamped = std::clamp(seconds, kShortest, kLongest);
  return static_cast<std::size_t>(std::log(clamped / kShortest) / std::log(kGrowth));
}

}  // namespace

CycleStatistics::CycleStatistics(double period) : bins_(binOf(kLongest) + 1, 0), period_{period} {
  if (!(period > 0.0)) throw UsageError("period " + formatDouble(period) + ": expected a time above 0 s");
}

void CycleStatistics::add(double seconds) {
  if (!(seconds > 0.0)) seconds = 0.0;
  ++bins_[binOf(seconds)];
  min_ = count_ ? std::min(min_, seconds) : seconds;
  max_ = count_ ? std::max(max_, seconds) : seconds;
  sum_ += seconds;
  ++count_;
  if (seconds > period_) ++overruns_;
}

void CycleStatistics::clear() {
  std::fill(bins_.begin(), bins_.end(), 0);
  min_ = max_ = sum_ = 0.0;
  count_ = overruns_ = 0;
}

double CycleStatistics::mean() const { return count_ ? sum_ / static_cast<double>(count_) : 0.0; }

double CycleStatistics::quantile(double share) const {
  ABSTAND_CHECK(share >= 0.0 && share <= 1.0);
  if (count_ == 0) return 0.0;
  const double rank = std::max(1.0, std::ceil(share * static_cast<double>(count_) - 1e-9));
  if (rank >= static_cast<double>(count_)) return max_;
  double below = 0.0;
  std::size_t bin = 0;
  while (below + static_cast<double>(bins_[bin]) < rank) below += static_cast<double>(bins_[bin++]);
  // Middle of the bin: the error is at most half its width.
  const double middle = kShortest * std::pow(kGrowth, static_cast<double>(bin) + 0.5);
  return std::clamp(middle, min_, max_);
}

}  // namespace abstand::scene
