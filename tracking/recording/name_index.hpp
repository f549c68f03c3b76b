// Names of points and joints as files spell them, found in the forms in which maps and marker sets name them.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "core/base/error.hpp"

namespace abstand::tracking {

/// Without the blanks at both ends, and without the end of a line with \r\n.
std::string_view trimmed(std::string_view text);

/// "A | B | C" as its names. Throws ParseError at `pos` for an empty one.
std::vector<std::string> namesBetweenBars(std::string_view list, const SourcePos& pos);

/// The form in which names are compared: small letters; '_', '.' and '-' are blanks.
std::string plainName(std::string_view name);

/// Finds names of a file without regard to capitals, to '_', '.', '-' against ' ', to a prefix and to a
/// namespace before the last ':'.
class NameIndex {
 public:
  /// Of two names with the same form the first counts.
  NameIndex(std::span<const std::string> names, std::span<const std::string> prefixes);

  /// The place of a name in the file; -1: not there.
  int find(std::string_view name) const;
  /// The points of "A + B + C", or of one name alone; empty where one of them is not there.
  std::vector<int> points(std::string_view sum) const;

 private:
  std::unordered_map<std::string, int> index_;
};

/// Whether a name is a sum, "A + B".
bool isSum(std::string_view name);

}  // namespace abstand::tracking
