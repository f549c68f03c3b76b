// Splits lines into words.
#pragma once

#include <string_view>
#include <vector>

namespace abstand::tracking {

/// Splits at blanks and parentheses; text after a '#' is a comment.
inline std::vector<std::string_view> wordsOf(std::string_view line) {
  const auto is_gap = [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '(' || c == ')'; };
  line = line.substr(0, line.find('#'));
  std::vector<std::string_view> words;
  for (std::size_t i = 0; i < line.size();) {
    while (i < line.size() && is_gap(line[i])) ++i;
    const std::size_t from = i;
    while (i < line.size() && !is_gap(line[i])) ++i;
    if (i > from) words.push_back(line.substr(from, i - from));
  }
  return words;
}

}  // namespace abstand::tracking
