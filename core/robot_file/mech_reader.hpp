// Iterates over the environments of a mechanism file; internal to its readers.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "core/robot_file/mech_words.hpp"

namespace abstand::robot_file {

/// A number in the file's units.
struct MechNumber {
  double value{0.0};
  int line{0}, column{0};
};

/// The text must outlive this object. Errors are ParseErrors with a position.
class MechReader {
 public:
  MechReader(std::string_view text, std::string name)
      : lines_(splitMechWords(text)), name_(std::move(name)) {}

  const std::string& fileName() const { return name_; }
  /// Null at the end of the file.
  const MechLine* nextLine() { return next_ < lines_.size() ? &lines_[next_++] : nullptr; }
  /// The next line of the environment `begin`, or null at its end tag. `known`: commands allowed in it.
  const MechLine* command(const MechLine& begin, const std::vector<std::string>& known);

  [[noreturn]] void fail(int line, int column, const std::string& message,
                         const std::string& hint = {}) const;
  [[noreturn]] void fail(const MechNumber& at, const std::string& message) const {
    fail(at.line, at.column, message);
  }
  /// Throws: word i is not among `known`.
  [[noreturn]] void unknown(const MechLine& line, std::size_t i, const std::string& expected,
                            const std::vector<std::string>& known) const;
  /// Throws unless the command of the line has exactly `count` values; `what` names them.
  void expectValues(const MechLine& line, std::size_t count, const std::string& what) const;
  void expectAlone(const MechLine& line) const;
  MechNumber number(const MechLine& line, std::size_t i, const std::string& what) const;
  /// An integer >= `min`.
  MechNumber integer(const MechLine& line, std::size_t i, int min, const std::string& what) const;

 private:
  std::vector<MechLine> lines_;
  std::string name_;
  std::size_t next_{0};
};

}  // namespace abstand::robot_file
