#include "tracking/recording/text_cursor.hpp"

namespace abstand::tracking {
namespace {

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }
bool isSpace(char c) { return isBlank(c) || c == '\n'; }
char small(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

}  // namespace

void TextCursor::skipSpace() {
  while (next_ < text_.size() && isSpace(text_[next_]))
    if (text_[next_++] == '\n') {
      ++line_;
      line_start_ = next_;
    }
  word_start_ = next_;
}

std::string_view TextCursor::word() {
  const auto w = peek();
  next_ += w.size();
  return w;
}

std::string_view TextCursor::peek() {
  skipSpace();
  std::size_t end = next_;
  if (end < text_.size() && (text_[end] == '{' || text_[end] == '}')) return text_.substr(end, 1);
  while (end < text_.size() && !isSpace(text_[end]) && text_[end] != '{' && text_[end] != '}') ++end;
  return text_.substr(next_, end - next_);
}

std::string_view TextCursor::restOfName() {
  while (next_ < text_.size() && isBlank(text_[next_])) ++next_;
  word_start_ = next_;
  std::size_t end = next_;
  while (end < text_.size() && text_[end] != '\n' && text_[end] != '{') ++end;
  const std::size_t start = next_;
  next_ = end;
  while (end > start && isBlank(text_[end - 1])) --end;
  return text_.substr(start, end - start);
}

bool TextCursor::consume(std::string_view expected) {
  skipSpace();
  std::size_t at = next_;
  for (const char c : expected) {
    if (c == ' ') {
      while (at < text_.size() && isBlank(text_[at])) ++at;
    } else if (at < text_.size() && small(text_[at]) == c) {
      ++at;
    } else {
      return false;
    }
  }
  next_ = at;
  return true;
}

}  // namespace abstand::tracking
