// What the HTML pages for people have in common.
#pragma once

#include <string>
#include <vector>

namespace abstand::report {

/// Doctype, head and style up to the body's first line: one column, light and dark by the reader's choice, no
/// script, nothing from outside.
std::string pageBegin(const std::string& title);
std::string pageEnd();

/// `<td>` or another tag around escaped text.
std::string cell(const std::string& text, const char* tag = "td");

/// A table with a header row; cells are escaped.
std::string htmlTable(const std::vector<std::string>& header,
                      const std::vector<std::vector<std::string>>& rows);

}  // namespace abstand::report
