// Set of margins by body part, link and pair, and its file format.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/margin/pair_margins.hpp"

namespace abstand::tune {

struct MarginRule {
  std::string part, link;  ///< "hand_left", "left_arm/link7"; empty: any
  margin::PairMargin margin;
};

/// Margins of pairs. A rule for a pair has precedence over those for its part and its link, of which the
/// larger of each number applies; `other` is for pairs without a rule.
struct MarginRules {
  std::string name;  ///< that of the file, or "per_link"
  std::vector<MarginRule> rules;
  std::optional<margin::PairMargin> other;

  /// nullopt if no rule applies.
  std::optional<margin::PairMargin> of(const std::string& part, const std::string& link) const;
};

/// Reads a file of margins (docs/margins.md, "Sets of margins"). Throws ParseError with line and column.
MarginRules loadMarginRules(const std::filesystem::path& file);

/// The text of such a file.
std::string marginRulesText(const MarginRules& rules);

}  // namespace abstand::tune
