#include "tracking/table/cells.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/number.hpp"
#include "core/text/message_text.hpp"
#include "tracking/recording/point_reader.hpp"

namespace abstand::tracking {

bool Cells::next(std::string_view& cell) {
  start_ = std::min(at_, line_.size());
  if (at_ > line_.size()) return false;
  const auto end = std::min(line_.find(separator_, at_), line_.size());
  cell = line_.substr(at_, end - at_);
  at_ = end + 1;
  const auto blank = [](char c) { return c == ' ' || c == '\t'; };
  while (!cell.empty() && blank(cell.front())) cell.remove_prefix(1);
  while (!cell.empty() && blank(cell.back())) cell.remove_suffix(1);
  return true;
}

double Cells::number(std::string_view cell) const {
  const auto v = parseDouble(cell);
  if (!v || std::abs(*v) > kLargestCoordinate)
    throw ParseError(pos(), "found " + text::inQuotes(cell) + ", expected a number below 1e9");
  return *v;
}

std::string_view Cells::need(const std::string& expected) {
  std::string_view cell;
  if (!next(cell)) throw ParseError(pos(), "found the end of the line, expected " + expected);
  return cell;
}

bool Lines::next(std::string_view& line) {
  if (text_.empty()) return false;
  const auto end = std::min(text_.find('\n'), text_.size());
  line = text_.substr(0, end);
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  text_.remove_prefix(std::min(end + 1, text_.size()));
  ++number_;
  return true;
}

}  // namespace abstand::tracking
