// Progress output of long operations.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace abstand {

/// Callback that receives the work done and the total. On a terminal it redraws one line at every percent;
/// otherwise it writes a line every 10 s, so nothing for shorter work. Not thread-safe.
class ProgressReport {
 public:
  static constexpr double kInterval = 10.0;  ///< s

  /// `seconds`: a monotonic clock.
  ProgressReport(std::string label, bool on_terminal, std::function<void(const std::string&)> write,
                 std::function<double()> seconds);
  void operator()(std::size_t done, std::size_t all);

 private:
  std::string label_;
  bool on_terminal_;
  std::function<void(const std::string&)> write_;
  std::function<double()> seconds_;
  double begin_, last_;
  std::size_t percent_{1000};
};

}  // namespace abstand
