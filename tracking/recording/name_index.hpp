// Finds names of points and joints of a file by the names in maps and marker sets.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "core/base/error.hpp"

namespace abstand::tracking {

/// Without blanks at both ends, and without \r
///  at the end.
std::string_view trimmed(std::string_view text);

/// Splits "A | B | C"; a name with a bar, or with quotes of its own around it, stands in double quotes.
/// Throws ParseError at `pos` for an empty name.
std::vector<std::string> namesBetweenBars(std::string_view list, const SourcePos& pos);

/// Normal form for comparison: lower case; '_', '.' and '-' are blanks.
std::string plainName(std::string_view name);

/// Finds names of a file ignoring case, '_', '.', '-' versus ' ', a prefix, and a namespace before the last
/// ':'.
class NameIndex {
 public:
  /// Of names with the same normal form the first is used.
  NameIndex(std::span<const std::string> names, std::span<const std::string> prefixes);

  /// Index of a name in the file, preferably of one that is exactly the same; -1: none.
  int find(std::string_view name) const;
  /// Indices of the points of "A + B + C", or of one name; empty if one of them does not exist.
  std::vector<int> points(std::string_view sum) const;

 private:
  std::unordered_map<std::string, int> exact_, index_;
};

/// True for a sum of names, "A + B".
bool isSum(std::string_view name);
/// The names of a sum.
std::vector<std::string> namesOfSum(std::string_view sum);

}  // namespace abstand::tracking
