// Lines and words of a mechanism file, with their places.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace abstand::robot_file {

struct MechWord {
  std::string_view text;
  int column{0};  ///< from 1, in bytes
};

/// A line that has at least one word; `line` counts from 1.
struct MechLine {
  int line{0};
  int end_column{0};  ///< where a word that is missing would have stood
  std::vector<MechWord> words;
};

/// Splits at spaces and tabs; `#` starts a comment anywhere; CRLF ends a line like LF. The words point into
/// `text`.
std::vector<MechLine> splitMechWords(std::string_view text);

}  // namespace abstand::robot_file
