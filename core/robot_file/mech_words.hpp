// Lines and words of a mechanism file, with their positions.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace abstand::robot_file {

struct MechWord {
  std::string_view text;
  int column{0};  ///< from 1, in bytes
};

/// A line with at least one word; `line` counts from 1.
struct MechLine {
  int line{0};
  int end_column{0};  ///< column at which a missing word would start
  std::vector<MechWord> words;
};

/// Splits at spaces and tabs; `#` starts a comment; CRLF ends a line like LF. The words point into `text`.
std::vector<MechLine> splitMechWords(std::string_view text);

}  // namespace abstand::robot_file
