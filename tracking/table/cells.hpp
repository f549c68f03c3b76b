// A line of a table, cell by cell, with the place of each.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.hpp"

namespace abstand::tracking {

/// Splits a line at its separators; cells lose the blanks at both ends. Keeps views of `line` and `file`.
class Cells {
 public:
  Cells(std::string_view line, const std::string& file, int number, char separator = ',')
      : line_(line), file_(file), number_(number), separator_(separator) {}

  /// The next cell, maybe empty; false after the last one.
  bool next(std::string_view& cell);
  /// A number that is finite and below 1e9, from the cell that next() gave. Throws ParseError.
  double number(std::string_view cell) const;
  /// Takes the next cell, which must be there. Throws ParseError saying that `expected` is missing.
  std::string_view need(const std::string& expected);
  /// Where the last cell began.
  SourcePos pos() const { return {file_, number_, static_cast<int>(start_) + 1}; }

 private:
  std::string_view line_;
  const std::string& file_;
  int number_;
  char separator_;
  std::size_t at_{0}, start_{0};
};

/// Walks over the lines of a text. A line loses its line feed and carriage return.
class Lines {
 public:
  explicit Lines(std::string_view text) : text_(text) {}
  bool next(std::string_view& line);
  /// The number of the last line, from 1.
  int number() const { return number_; }

 private:
  std::string_view text_;
  int number_{0};
};

}  // namespace abstand::tracking
