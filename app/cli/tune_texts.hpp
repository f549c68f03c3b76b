// The answers of `tune`.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/tune/margin_table.hpp"

namespace abstand::cli {

struct TuneAnswer {
  tune::TuneOptions options;
  std::vector<tune::TunedRecording> recordings;
  struct Failed {
    std::string recording, error;
  };
  std::vector<Failed> failed;
  tune::MarginTable table;
  bool interrupted{false};
};

nlohmann::ordered_json tuneJson(const TuneAnswer& answer);
std::string tuneText(const TuneAnswer& answer);

}  // namespace abstand::cli
