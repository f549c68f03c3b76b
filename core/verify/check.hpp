// What a check of the engine is asked, and what it answers.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/math/transform.hpp"

namespace abstand::verify {

/// Shared by all checks. The same options give the same results on any number of threads.
struct VerifyOptions {
  std::size_t poses{100'000};  ///< random and adversarial poses of each field kind, against exact distances
  std::uint64_t seed{1};
  bool quick{false};  ///< coarser paths and fewer resolutions; limits stay
  int threads{0};     ///< 0: as many as the machine has
  /// Called now and then by the thread that called the check: done and all, in any unit.
  std::function<void(std::size_t, std::size_t)> progress;
  /// When it says true, the check ends early and its result counts as not passed.
  std::function<bool()> interrupted;

  bool stop() const { return interrupted && interrupted(); }
};

struct Series {
  std::string name;
  std::vector<double> x, y;
};

/// Lines through the points of each series. On a logarithmic axis values that are not positive are left out.
struct Plot {
  std::string title, x_label, y_label;
  bool log_x{false}, log_y{false};
  std::vector<Series> series;
};

struct Table {
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
};

/// One check: `worst`, `p50`, `p99` are of the number that `quantity` names, one a pose; it passes when no
/// pose is beyond `limit`.
struct CheckResult {
  std::string name;      ///< short, with dots: "bound.mixed"
  std::string what;      ///< what was tested, a sentence
  std::string quantity;  ///< what the numbers are, with unit
  std::string reason;    ///< why this limit
  std::size_t poses{0};
  double worst{kNaN}, p50{kNaN}, p99{kNaN}, limit{kNaN};
  std::size_t breaches{0};  ///< poses beyond the limit
  bool passed{false};
  Table table;  ///< may be empty
  std::vector<Plot> plots;
};

}  // namespace abstand::verify
