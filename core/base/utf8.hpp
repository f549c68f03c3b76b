// Validates UTF-8 of untrusted text that is copied to JSON, CSV and messages.
#pragma once

#include <string_view>

namespace abstand {

/// Length in bytes of the UTF-8 character at the start of `text`; 0 if it is invalid (truncated, overlong, a
/// surrogate) or a control character. `text` is not empty.
std::size_t characterLength(std::string_view text);

/// True for a UTF-8 character that changes the lines or the order of a text without being visible: a C1
/// control (U+0080 to U+009F), a line separator (U+2028, U+2029) or a bidirectional mark (U+202A to U+202E,
/// U+2066 to U+2069).
bool isHiddenControl(std::string_view character);

/// True if characterLength() accepts every character.
bool isPlainText(std::string_view text);

}  // namespace abstand
