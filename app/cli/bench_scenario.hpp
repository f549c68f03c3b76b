// abstand bench --scenario: one row of a peer benchmark's tables.
#pragma once

#include "app/cli/command_line.hpp"

namespace abstand::cli {

/// Command line of the peer benchmark's harness: runs frames f with (f - start) mod period < block until
/// `budget` seconds of measured work are spent; one JSON line on stdout, values of the pairs to `dump`.
struct BenchScenario {
  std::string scenario, mode{"distance"}, variant{"h4"}, dump, out;
  int block{10}, period{100}, start{0};
  double budget{60.0};
};

/// Throws ParseError, UsageError.
int benchScenario(const BenchScenario& args);

}  // namespace abstand::cli
