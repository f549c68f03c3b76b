// Reads JSON sequentially without a document tree.
#pragma once

#include <charconv>
#include <cmath>
#include <string_view>

namespace abstand::serve {

/// Each function consumes what its name says, after blanks, or consumes nothing and returns false. No
/// allocation, no throw.
class JsonScanner {
 public:
  explicit JsonScanner(std::string_view text) : text_(text) {}

  bool mark(char c) noexcept {
    skipBlanks();
    if (text_.empty() || text_.front() != c) return false;
    text_.remove_prefix(1);
    return true;
  }
  bool word(std::string_view w) noexcept {
    skipBlanks();
    if (text_.substr(0, w.size()) != w) return false;
    text_.remove_prefix(w.size());
    return true;
  }
  /// A string without escapes, which would need memory to decode.
  bool string(std::string_view& out) noexcept {
    skipBlanks();
    if (text_.empty() || text_.front() != '"') return false;
    const std::size_t end = text_.find_first_of("\"\\\n", 1);
    if (end == text_.npos || text_[end] != '"') return false;
    out = text_.substr(1, end - 1);
    text_.remove_prefix(end + 1);
    return true;
  }
  /// A finite number.
  bool number(double& out) noexcept {
    skipBlanks();
    const std::size_t digit = !text_.empty() && text_.front() == '-' ? 1 : 0;
    if (digit >= text_.size() || text_[digit] < '0' || text_[digit] > '9') return false;
    const auto r = std::from_chars(text_.data(), text_.data() + text_.size(), out);
    if (r.ec != std::errc() || !std::isfinite(out)) return false;
    text_.remove_prefix(static_cast<std::size_t>(r.ptr - text_.data()));
    return true;
  }
  bool atEnd() noexcept {
    skipBlanks();
    return text_.empty();
  }

 private:
  void skipBlanks() noexcept {
    const std::size_t n = text_.find_first_not_of(" \t\r\n");
    text_.remove_prefix(n == text_.npos ? text_.size() : n);
  }
  std::string_view text_;
};

}  // namespace abstand::serve
