// Set of margins by body part, link and pair, and its file format.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/margin/pair_margins.hpp"

namespace abstand::margin {

/// Classes of pairs that may have a margin of their own.
inline const std::vector<std::string> kMarginClasses{"person_robot", "person_thing", "robot_robot",
                                                     "robot_thing"};

struct MarginRule {
  std::string part, link;  ///< "hand_left", "left_arm/link7"; empty: any
  PairMargin margin;
};

/// Margins of pairs. A rule for a pair has precedence over those for its part and its link, of which the
/// larger of each number applies, or their sum; `other` is for pairs without a rule.
struct MarginRules {
  std::string name;  ///< that of the file, or "per_link"
  std::vector<MarginRule> rules;
  std::optional<PairMargin> other;
  bool sum{false};  ///< numbers of part and link are added
  /// m, by a name of kMarginClasses: margins of all pairs of a class, whatever else is said. Only
  /// `person_robot` is for parts and links; the others are for the window.
  std::map<std::string, double> classes{};

  /// nullopt if no rule applies.
  std::optional<PairMargin> of(const std::string& part, const std::string& link) const;
};

/// Reads the text of a file of margins (docs/margins.md, "Sets of margins"). Throws ParseError with line and
/// column.
/// @param part_names  that are known
MarginRules parseMarginRules(const std::string& text, const std::string& file,
                             const std::vector<std::string>& part_names);

/// The text of such a file.
std::string marginRulesText(const MarginRules& rules);

}  // namespace abstand::margin
