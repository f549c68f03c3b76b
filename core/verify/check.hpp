// Options and results of a check of the engine.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/math/transform.hpp"

namespace abstand::verify {

/// VerifyOptions::poses of a quick run.
inline constexpr std::size_t kQuickPoses = 3'000;

/// Options of all checks. The same options give the same results on any number of threads.
struct VerifyOptions {
  std::size_t poses{100'000};  ///< random and adversarial poses of each field kind, against exact distances
  std::uint64_t seed{1};
  bool quick{false};  ///< coarser paths and fewer resolutions; limits are unchanged
  int threads{0};     ///< 0: hardware concurrency
  /// Called occasionally by the calling thread: work done and total, in any unit.
  std::function<void(std::size_t, std::size_t)> progress;
  /// Polled; if true, the check ends early and counts as failed.
  std::function<bool()> interrupted;

  bool stop() const { return interrupted && interrupted(); }
};

struct Series {
  std::string name;
  std::vector<double> x, y;
};

/// Line plot of series of points. On a logarithmic axis values that are not positive are omitted.
struct Plot {
  std::string title, x_label, y_label;
  bool log_x{false}, log_y{false};
  std::vector<Series> series;
};

struct Table {
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
};

/// Result of one check: `worst`, `p50`, `p99` are of the value described by `quantity`, one for each pose;
/// passed if no pose exceeds `limit`.
struct CheckResult {
  std::string name;      ///< short, with dots: "bound.mixed"
  std::string what;      ///< description of the test, one sentence
  std::string quantity;  ///< description of the values, with unit
  std::string reason;    ///< reason of the limit
  std::size_t poses{0};
  double worst{kNaN}, p50{kNaN}, p99{kNaN}, limit{kNaN};
  std::size_t breaches{0};  ///< poses that exceed the limit
  bool passed{false};
  Table table;  ///< may be empty
  std::vector<Plot> plots;
};

}  // namespace abstand::verify
