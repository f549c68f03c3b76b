#include "core/text/message_text.hpp"

#include <charconv>

namespace abstand::text {
namespace {

constexpr std::size_t kLongestQuote = 40;

}  // namespace

std::string lowerCase(std::string_view text) {
  std::string s(text);
  for (char& c : s)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return s;
}

std::string inQuotes(std::string_view found) {
  std::string s = "'";
  for (const char c : found.substr(0, kLongestQuote)) s += c >= ' ' && c <= '~' ? c : '?';
  return s + (found.size() > kLongestQuote ? "...'" : "'");
}

std::string rounded(double value, int digits) {
  char buffer[400];  // the largest double has 309 digits before the point
  const auto r = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed, digits);
  return {buffer, r.ptr};
}

}  // namespace abstand::text
