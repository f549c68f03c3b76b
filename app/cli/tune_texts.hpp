// The answers of `tune`.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/tune/study.hpp"

namespace abstand::cli {

struct TuneAnswer {
  tune::TuneOptions options;
  std::vector<tune::TunedRecording> recordings;
  std::vector<tune::FailedRun> failed;
  std::optional<std::size_t> made, kept;  ///< result files, where there are any
  tune::MarginTable table;
  bool interrupted{false};
};

nlohmann::ordered_json tuneJson(const TuneAnswer& answer);
std::string tuneText(const TuneAnswer& answer);

}  // namespace abstand::cli
