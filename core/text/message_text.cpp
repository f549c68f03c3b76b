#include "core/text/message_text.hpp"

#include <algorithm>
#include <charconv>

#include "core/base/utf8.hpp"

namespace abstand::text {
namespace {

constexpr std::size_t kLongestQuote = 40;  // characters

std::string quoted(std::string_view found, char quote) {
  std::string s(1, quote);
  for (std::size_t i = 0; i < kLongestQuote && !found.empty(); ++i) {
    const std::size_t length = characterLength(found);
    const std::string_view character = found.substr(0, std::max<std::size_t>(length, 1));
    if (length == 0 || isHiddenControl(character))
      s += '?';
    else
      s += character;
    found.remove_prefix(character.size());
  }
  if (!found.empty()) s += "...";
  return s + quote;
}

}  // namespace

std::string lowerCase(std::string_view text) {
  std::string s(text);
  for (char& c : s)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return s;
}

std::string_view trimmed(std::string_view text, std::string_view blank) {
  return trimmed(text, blank, blank);
}

std::string_view trimmed(std::string_view text, std::string_view leading, std::string_view trailing) {
  const auto begin = text.find_first_not_of(leading);
  if (begin == std::string_view::npos) return {};
  text.remove_prefix(begin);
  return text.substr(0, text.find_last_not_of(trailing) + 1);
}

std::string inQuotes(std::string_view found) { return quoted(found, '\''); }

std::string inDoubleQuotes(std::string_view found) { return found.empty() ? "nothing" : quoted(found, '"'); }

std::string rounded(double value, int digits) {
  char buffer[400];  // the largest double has 309 digits before the point
  const auto r = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed, digits);
  return {buffer, r.ptr};
}

}  // namespace abstand::text
