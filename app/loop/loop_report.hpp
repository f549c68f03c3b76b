// Report of the reacting robots of a closed loop.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/loop/closed_loop.hpp"

namespace abstand::loop {

struct ReactionReport {
  struct Extreme {
    std::string a, b;
    double t{0.0}, value{0.0};
  };
  std::string name;
  bool positioned{false};
  std::optional<Extreme> nearest, nearest_person;  ///< m, as in RobotRecord
  RobotRecord record;
  std::vector<safety::StopEntry> stops;  ///< the last ones
  std::vector<std::string> lines;        ///< the same as sentences
  std::size_t stop_count{0};             ///< total number
  safety::StopState state{safety::StopState::kRunning};
  std::string remark;  ///< massRemark(); empty: its own inertia was used
};

/// Reports of the reacting robots, in the order of the session.
std::vector<ReactionReport> reportOf(const ClosedLoop& loop);

}  // namespace abstand::loop
