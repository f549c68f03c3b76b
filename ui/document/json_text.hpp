// Text of a JSON file, one value a line.
#pragma once

#include <string>
#include <string_view>

namespace abstand::ui {

/// In quotes, with quotes, backslashes and control characters escaped.
std::string jsonString(std::string_view text);

/// Writes maps and lists with two blanks a level. The same calls give the same bytes.
class JsonText {
 public:
  /// Within a map each value has its name, within a list the name is empty.
  void open(std::string_view name, char bracket);
  void close();
  /// `value` as it stands in the file.
  void add(std::string_view name, std::string_view value);
  void addText(std::string_view name, std::string_view text) { add(name, jsonString(text)); }
  void addNumber(std::string_view name, double value);
  void addFlag(std::string_view name, bool value) { add(name, value ? "true" : "false"); }

  /// All brackets must be closed.
  std::string text() const { return text_ + "\n"; }

 private:
  void begin(std::string_view name);

  std::string text_;
  std::string closing_;  ///< brackets that are still open
  bool first_{true};     ///< nothing stands in the innermost bracket
};

}  // namespace abstand::ui
