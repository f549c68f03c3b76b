// Terms of the protective distance and their sources, as lines of text in result files.
#pragma once

#include <string>

#include "app/tune/recording_tune.hpp"

namespace abstand::tune {

/// The terms of a table.
std::vector<CitedTerm> citedTerms(const safety::SeparationStandard& standard);

/// Edition of the speeds of people: that of the table, without one that of the program's defaults.
std::string speedsEdition(const TunedRecording& recording);

/// One line: key, value, source, doubt, with tabs between them.
std::string termLine(const CitedTerm& term);
/// Reads such a line; `file` is named in errors. Throws ParseError.
CitedTerm termOf(const std::string& line, const std::string& file);

}  // namespace abstand::tune
