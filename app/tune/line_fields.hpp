// Fields of a line of text in a result file, with tabs between them.
#pragma once

#include <string>
#include <vector>

namespace abstand::tune {

/// `text` with spaces instead of separators of fields and lines.
std::string fieldText(std::string text);
std::vector<std::string> fieldsOf(const std::string& line);

}  // namespace abstand::tune
