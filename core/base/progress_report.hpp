// How far long work is, for people who wait for it.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace abstand {

/// A function that is called with what is done and all of it. On a terminal it redraws one line at every
/// percent; on a pipe or a file it writes a line when 10 s have passed since the last one, and nothing about
/// shorter work. Not for several threads at once.
class ProgressReport {
 public:
  static constexpr double kInterval = 10.0;  ///< s

  /// `seconds`: a clock that does not fall.
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
