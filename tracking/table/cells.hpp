// Cells of a table line, with their positions.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.hpp"

namespace abstand::tracking {

/// Splits a line at its separators and trims blanks. Refers to `line` and `file`.
class Cells {
 public:
  Cells(std::string_view line, const std::string& file, int number, char separator = ',')
      : line_(line), file_(file), number_(number), separator_(separator) {}

  /// The next cell, possibly empty; false after the last one.
  bool next(std::string_view& cell);
  /// The cell from next() as a finite number below 1e9. Throws ParseError.
  double number(std::string_view cell) const;
  /// The next cell, which must exist. Throws ParseError that `expected` is missing.
  std::string_view need(const std::string& expected);
  /// Position of the start of the last cell.
  SourcePos pos() const { return {file_, number_, static_cast<int>(start_) + 1}; }

 private:
  std::string_view line_;
  const std::string& file_;
  int number_;
  char separator_;
  std::size_t at_{0}, start_{0};
};

/// Iterates over the lines of a text, without line feed and carriage return.
class Lines {
 public:
  explicit Lines(std::string_view text) : text_(text) {}
  bool next(std::string_view& line);
  /// Number of the last line, from 1.
  int number() const { return number_; }

 private:
  std::string_view text_;
  int number_{0};
};

}  // namespace abstand::tracking
