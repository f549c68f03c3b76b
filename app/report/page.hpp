// Common parts of the HTML pages.
#pragma once

#include <string>
#include <vector>

namespace abstand::report {

/// Doctype, head and style up to the start of the body: one column, light and dark by the reader's
/// preference, self-contained, no scripts.
std::string pageBegin(const std::string& title);
std::string pageEnd();

/// `text` is escaped and put into `<td>` or another tag.
std::string cell(const std::string& text, const char* tag = "td");

/// A table with a header row; cells are escaped.
std::string htmlTable(const std::vector<std::string>& header,
                      const std::vector<std::vector<std::string>>& rows);

}  // namespace abstand::report
