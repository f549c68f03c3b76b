// Lines and words of text formats; internal to the mesh readers.
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/error.hpp"
#include "core/base/number.hpp"
#include "core/math/transform.hpp"
#include "core/text/message_text.hpp"

namespace abstand::text {

inline constexpr std::string_view kBlank = " \t\r\n\v\f";
inline constexpr bool isBlank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

/// Removes the next word from `rest` and returns it; empty at the end.
inline std::string_view nextWord(std::string_view& rest) {
  std::size_t begin = 0;
  while (begin < rest.size() && isBlank(rest[begin])) ++begin;
  std::size_t end = begin;
  while (end < rest.size() && !isBlank(rest[end])) ++end;
  const auto word = rest.substr(begin, end - begin);
  rest.remove_prefix(end);
  return word;
}

/// The word as a number. Throws ParseError if it is not a finite number.
inline double number(std::string_view word, const SourcePos& pos) {
  const auto value = parseDouble(word);
  if (!value) throw ParseError(pos, "found " + inDoubleQuotes(word) + ", expected a finite number");
  return *value;
}

/// The next three words as coordinates.
inline Vector3d nextPoint(std::string_view& rest, const SourcePos& pos) {
  Vector3d p;
  for (double& c : p) c = number(nextWord(rest), pos);
  return p;
}

/// Splits a text into lines that end in
/// , \r
///  or \r; line numbers count from 1.
class Lines {
 public:
  Lines(std::string_view text, std::string file) : rest_(text), pos_{std::move(file), 0, 0} {}

  /// The next line; nullopt at the end.
  std::optional<std::string_view> next() {
    if (rest_.empty()) return std::nullopt;
    ++pos_.line;
    std::size_t end = 0;
    while (end < rest_.size() && rest_[end] != '\r' && rest_[end] != '\n') ++end;
    const auto line = rest_.substr(0, end);
    rest_.remove_prefix(end);
    if (rest_.starts_with("\r\n")) rest_.remove_prefix(1);
    if (!rest_.empty()) rest_.remove_prefix(1);
    return line;
  }

  /// The next line that has a word, without its #-comment; nullopt at the end.
  std::optional<std::string_view> nextData() {
    while (auto line = next()) {
      const auto data = line->substr(0, line->find('#'));
      if (data.find_first_not_of(kBlank) != std::string_view::npos) return data;
    }
    return std::nullopt;
  }

  std::string_view rest() const { return rest_; }
  const SourcePos& pos() const { return pos_; }

 private:
  std::string_view rest_;
  SourcePos pos_;
};

}  // namespace abstand::text
