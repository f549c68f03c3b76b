// Files of margin sets.
#pragma once

#include <filesystem>

#include "core/margin/margin_rules.hpp"

namespace abstand::tune {

using margin::MarginRule;
using margin::MarginRules;
using margin::marginRulesText;

/// Reads a file of margins (docs/margins.md, "Sets of margins"). Throws ParseError with line and column.
MarginRules loadMarginRules(const std::filesystem::path& file);

}  // namespace abstand::tune
