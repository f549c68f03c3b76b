// Position in a text, with line and column, for parsers of keyword files.
#pragma once

#include <string>
#include <string_view>

#include "core/base/error.hpp"

namespace abstand::tracking {

/// Iterates over a text without copying it. Words end at white space; '{' and '}' are words of their own.
class TextCursor {
 public:
  TextCursor(std::string_view text, std::string file) : text_(text), file_(std::move(file)) {}

  /// The next word; empty at the end of the text.
  std::string_view word();
  /// The next word without advancing.
  std::string_view peek();
  /// The rest of the current line up to a '{', without white space at both ends.
  std::string_view restOfName();
  /// Consumes `expected` (lower case), ignoring case, after white space. Spaces in it match any white space
  /// or none.
  bool consume(std::string_view expected);

  /// Position of the start of the last word.
  SourcePos pos() const { return {file_, line_, static_cast<int>(word_start_ - line_start_) + 1}; }
  int line() const { return line_; }
  std::size_t offset() const { return next_; }
  std::size_t lineStart() const { return line_start_; }

 private:
  void skipSpace();

  std::string_view text_;
  std::string file_;
  std::size_t next_{0}, word_start_{0}, line_start_{0};
  int line_{1};
};

}  // namespace abstand::tracking
