#include "core/base/message_line.hpp"

#include <algorithm>

#include "core/base/utf8.hpp"

namespace abstand {
namespace {

constexpr std::string_view kLeftOut = " [...] ";

void addEscaped(std::string& out, std::string_view bytes) {
  constexpr char kDigits[] = "0123456789abcdef";
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    out += "\\x";
    out += kDigits[byte >> 4];
    out += kDigits[byte & 15];
  }
}

bool isContinuation(char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; }

}  // namespace

std::string messageLine(std::string_view text, std::size_t max_bytes) {
  // Does not scan the part that is certainly left out.
  std::string_view tail;
  bool is_cut = text.size() > max_bytes;
  if (is_cut) {
    tail = text.substr(text.size() - max_bytes / 2);
    text = text.substr(0, max_bytes - max_bytes / 2);
    // A character that the cut would split is left out whole.
    for (int i = 0; i < 3 && !text.empty() && isContinuation(text.back()); ++i) text.remove_suffix(1);
    if (!text.empty() && static_cast<unsigned char>(text.back()) >= 0xc0) text.remove_suffix(1);
    for (int i = 0; i < 3 && !tail.empty() && isContinuation(tail.front()); ++i) tail.remove_prefix(1);
  }
  std::string out;
  for (std::string_view part : {text, tail}) {
    if (part.data() == tail.data() && is_cut && !tail.empty()) out += kLeftOut;
    while (!part.empty()) {
      const char lead = part.front();
      std::size_t length = 1;
      if (lead == '\n' || lead == '\r' || lead == '\t' || lead == '\v' || lead == '\f') {
        out += ' ';
      } else {
        length = characterLength(part);
        const std::string_view character = part.substr(0, std::max<std::size_t>(length, 1));
        if (length == 0 || isHiddenControl(character))
          addEscaped(out, character);
        else
          out += character;
        length = character.size();
      }
      part.remove_prefix(length);
    }
  }
  // Escapes are longer than what they stand for.
  if (out.size() > 4 * max_bytes) out.resize(4 * max_bytes);
  return out;
}

std::string messageLines(std::string_view text, std::size_t max_bytes_a_line) {
  std::string out;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    out += messageLine(text.substr(0, end), max_bytes_a_line);
    if (end == text.npos) break;
    out += '\n';
    text.remove_prefix(end + 1);
  }
  return out;
}

}  // namespace abstand
