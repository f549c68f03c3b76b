// Text from strangers that goes on into JSON, CSV and messages.
#pragma once

#include <string_view>

namespace abstand {

/// Length in bytes of the UTF-8 character at the beginning of `text`; 0 when it is none (cut, overlong, a
/// surrogate) and for control characters. `text` is not empty.
std::size_t characterLength(std::string_view text);

/// Every character is one.
bool isPlainText(std::string_view text);

}  // namespace abstand
