#include "app/session/times_between.hpp"

#include "core/base/error.hpp"

namespace abstand::session {

std::vector<double> timesBetween(std::vector<double> times, std::optional<double> start,
                                 std::optional<double> end) {
  constexpr double kTolerance = 1e-9;
  std::erase_if(
      times, [&](double t) { return (start && t < *start - kTolerance) || (end && t > *end + kTolerance); });
  if (times.empty()) throw UsageError("no frame lies between --start and --end");
  return times;
}

}  // namespace abstand::session
