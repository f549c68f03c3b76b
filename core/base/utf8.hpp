// Validates UTF-8 of untrusted text that is copied to JSON, CSV and messages.
#pragma once

#include <string_view>

namespace abstand {

/// Length in bytes of the UTF-8 character at the start of `text`; 0 if it is invalid (truncated, overlong, a
/// surrogate) or a control character. `text` is not empty.
std::size_t characterLength(std::string_view text);

/// True if characterLength() accepts every character.
bool isPlainText(std::string_view text);

}  // namespace abstand
