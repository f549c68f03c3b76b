#include "app/cli/things_report.hpp"

#include <cmath>

#include "app/cli/command_line.hpp"

namespace abstand::cli {

nlohmann::ordered_json thingsJson(bool removed, double share, const tracking::DisplacedThings& displaced) {
  const bool is_known = std::isfinite(share);
  const auto orNull = [&](double value) {
    return is_known ? nlohmann::ordered_json(value) : nlohmann::ordered_json();
  };
  return {{"removed", removed},
          {"shown", orNull(share)},
          {"displacement", orNull(displaced.displacement())},
          {"band", displaced.band()}};
}

std::string thingsText(double share, const tracking::DisplacedThings& displaced) {
  if (!std::isfinite(share)) return {};
  std::string text = format("found in %.0f %% of their pixels", 100.0 * share);
  if (displaced.band() > 0.0) text += format(", displaced by up to %.0f mm", 1e3 * displaced.displacement());
  return text;
}

}  // namespace abstand::cli
