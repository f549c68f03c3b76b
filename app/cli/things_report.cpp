#include "app/cli/things_report.hpp"

#include <cmath>

#include "app/cli/command_line.hpp"
#include "app/cli/json_values.hpp"

namespace abstand::cli {

nlohmann::ordered_json thingsJson(bool removed, double share, const tracking::DisplacedThings& displaced) {
  return {{"removed", removed},
          {"shown", numberOrNull(share)},
          {"displacement", numberOrNull(std::isfinite(share) ? displaced.displacement() : kNaN)},
          {"band", displaced.band()}};
}

std::string thingsText(double share, const tracking::DisplacedThings& displaced) {
  if (!std::isfinite(share)) return {};
  std::string text = format("found in %.0f %% of their pixels", 100.0 * share);
  if (displaced.band() > 0.0) text += format(", displaced by up to %.0f mm", 1e3 * displaced.displacement());
  return text;
}

}  // namespace abstand::cli
