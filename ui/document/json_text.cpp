#include "ui/document/json_text.hpp"

#include "core/base/number.hpp"

namespace abstand::ui {

std::string jsonString(std::string_view text) {
  constexpr std::string_view kHex = "0123456789abcdef";
  std::string out = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (c == '\n') {
      out += "\\n";
    } else if (code < 0x20 || code == 0x7f) {
      out += "\\u00";
      out += kHex[code >> 4];
      out += kHex[code & 15];
    } else {
      out += c;
    }
  }
  return out + '"';
}

void JsonText::begin(std::string_view name) {
  if (!closing_.empty()) {
    if (!first_) text_ += ',';
    text_ += '\n';
    text_.append(2 * closing_.size(), ' ');
  }
  if (!name.empty()) text_ += jsonString(name) + ": ";
  first_ = false;
}

void JsonText::open(std::string_view name, char bracket) {
  begin(name);
  text_ += bracket;
  closing_ += bracket == '{' ? '}' : ']';
  first_ = true;
}

void JsonText::close() {
  const char bracket = closing_.back();
  closing_.pop_back();
  if (!first_) {
    text_ += '\n';
    text_.append(2 * closing_.size(), ' ');
  }
  text_ += bracket;
  first_ = false;
}

void JsonText::add(std::string_view name, std::string_view value) {
  begin(name);
  text_ += value;
}

void JsonText::addNumber(std::string_view name, double value) { add(name, formatDouble(value)); }

}  // namespace abstand::ui
