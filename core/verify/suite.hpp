// All checks of the engine, by name.
#pragma once

#include <string_view>
#include <vector>

#include "core/verify/check.hpp"

namespace abstand::verify {

/// A family of checks.
struct CheckFamily {
  std::string_view name;
  std::vector<CheckResult> (*run)(const VerifyOptions&);
};

/// In the order of the report.
const std::vector<CheckFamily>& checkFamilies();

}  // namespace abstand::verify
