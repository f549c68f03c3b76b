// Which assumptions a user has stated.
#pragma once

#include <string>
#include <vector>

#include "app/tune/recording_tune.hpp"

namespace abstand::tune {

/// Names of assumptions: keys of the JSON's `assumed`, then "separation.KEY" for each term of S_p.
std::vector<std::string> assumptionNames();

/// True if the user stated the option (TuneOptions::stated), or if its value is not the default, so that
/// somebody must have: callers without a command line need not list names.
bool isStated(const TuneOptions& options, const std::string& name);

}  // namespace abstand::tune
