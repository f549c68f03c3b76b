// Errors of the program: invalid input (ParseError, UsageError) and internal errors (ABSTAND_CHECK).
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace abstand {

/// A place in a file. Line and column count from 1; 0 means "not known" and is not printed.
struct SourcePos {
  std::string file;
  int line{0};
  int column{0};
};

/// Invalid input: a file, a stream, an argument. what() is one line, `FILE:LINE:COLUMN: error: MESSAGE`,
/// followed by `hint: ...` on a second line if there is a hint. The message states what was found and what
/// was expected.
class ParseError : public std::runtime_error {
 public:
  ParseError(const SourcePos& pos, const std::string& message, const std::string& hint = {});
  const SourcePos& pos() const { return pos_; }
  /// The message without place and hint.
  const std::string& message() const { return message_; }

 private:
  SourcePos pos_;
  std::string message_;
};

/// A value that the user gave on the command line or in the window is out of range (exit code 2).
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The name among `known` that is closest to `name` (edit distance at most 3), or empty.
std::string nearestName(const std::string& name, const std::vector<std::string>& known);

[[noreturn]] void checkFailed(const char* condition, const char* file, int line);

}  // namespace abstand

/// Internal error: aborts the program, in every build type.
#define ABSTAND_CHECK(condition) \
  ((condition) ? static_cast<void>(0) : ::abstand::checkFailed(#condition, __FILE__, __LINE__))
