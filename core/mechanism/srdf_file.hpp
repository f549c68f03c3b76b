// SRDF, the file beside a URDF that says which links need not be checked against each other.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/error.hpp"

namespace abstand {

/// `<disable_collisions link1="A" link2="B" reason="..."/>`.
struct DisabledPair {
  std::string link1, link2, reason;
  SourcePos pos;
};

struct Srdf {
  std::string robot;  ///< its name
  std::vector<DisabledPair> disabled;
};

/// Reads the disabled pairs; groups, states and whatever else MoveIt keeps there are passed over. Throws
/// ParseError with line and column.
Srdf parseSrdf(const std::string& text, const std::string& file);
Srdf loadSrdf(const std::filesystem::path& file);

/// Only the name and the disabled pairs.
std::string srdfText(const Srdf& srdf);

}  // namespace abstand
