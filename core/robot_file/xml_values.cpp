#include "core/robot_file/xml_values.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/number.hpp"
#include "core/base/utf8.hpp"
#include "core/text/text_lines.hpp"

namespace abstand::robot_file {
namespace {

using text::inDoubleQuotes;

constexpr std::array<std::pair<std::string_view, char>, 5> kEntities{
    {{"&lt;", '<'}, {"&gt;", '>'}, {"&amp;", '&'}, {"&quot;", '"'}, {"&apos;", '\''}}};

std::string tag(const XmlElement& e) { return "<" + std::string(e.name.substr(0, 40)) + ">"; }

}  // namespace

void XmlValues::fail(const XmlElement& e, const std::string& message, const std::string& hint) const {
  throw ParseError(pos(e), message, hint);
}

std::string XmlValues::warning(const XmlElement& e, const std::string& text) const {
  return file_ + ":" + std::to_string(e.line) + ":" + std::to_string(e.column) + ": " + text;
}

std::optional<std::string> XmlValues::text(const XmlElement& e, std::string_view key) const {
  for (const auto& [k, value] : e.attributes) {
    if (k != key) continue;
    std::string plain;
    for (std::string_view rest = value; !rest.empty();) {
      if (rest[0] == '\t' || rest[0] == '\n' || rest[0] == '\r') {  // white space as defined by XML
        plain += ' ';
        rest.remove_prefix(1);
        continue;
      }
      const std::size_t length = characterLength(rest);
      if (length == 0)
        fail(e, "found a character in " + std::string(key) + " of " + tag(e) +
                    " that is none of UTF-8, expected text");
      if (rest[0] != '&') {
        plain += rest.substr(0, length);
        rest.remove_prefix(length);
        continue;
      }
      const auto* const found = std::find_if(kEntities.begin(), kEntities.end(), [&](const auto& entity) {
        return rest.starts_with(entity.first);
      });
      if (found == kEntities.end())
        fail(e, "found " + text::inDoubleQuotes(rest.substr(0, 12)) + " in " + std::string(key) + " of " +
                    tag(e) + ", expected &lt; &gt; &amp; &quot; or &apos;");
      plain += found->second;
      rest.remove_prefix(found->first.size());
    }
    return plain;
  }
  return std::nullopt;
}

std::string XmlValues::needText(const XmlElement& e, std::string_view key) const {
  auto value = text(e, key);
  if (!value || value->empty())
    fail(e, "found " + tag(e) + " without " + std::string(key) + ", expected one");
  return *value;
}

double XmlValues::parse(const XmlElement& e, std::string_view key, std::string_view word) const {
  const auto value = parseDouble(word);
  if (!value)
    fail(e, "found " + text::inDoubleQuotes(word) + " for " + std::string(key) + " of " + tag(e) +
                ", expected a finite number");
  if (std::abs(*value) > kLargest)
    fail(e, "found " + text::inDoubleQuotes(word) + " for " + std::string(key) + " of " + tag(e) +
                ", expected at most " + formatDouble(kLargest) + " in size");
  return *value;
}

std::optional<double> XmlValues::number(const XmlElement& e, std::string_view key) const {
  const auto value = text(e, key);
  if (!value) return std::nullopt;
  std::string_view rest = *value;
  const auto word = text::nextWord(rest);
  if (!text::nextWord(rest).empty()) return parse(e, key, *value);
  return parse(e, key, word);
}

double XmlValues::needNumber(const XmlElement& e, std::string_view key) const {
  needText(e, key);
  return *number(e, key);
}

std::optional<Vector3d> XmlValues::vector(const XmlElement& e, std::string_view key) const {
  const auto value = text(e, key);
  if (!value) return std::nullopt;
  std::vector<std::string_view> words;
  for (std::string_view rest = *value, word; !(word = text::nextWord(rest)).empty();) words.push_back(word);
  if (words.size() != 3)
    fail(e, "found " + std::to_string(words.size()) + (words.size() == 1 ? " number" : " numbers") + " for " +
                std::string(key) + " of " + tag(e) + ", expected three");
  Vector3d v;
  for (std::size_t i = 0; i < 3; ++i) v[static_cast<int>(i)] = parse(e, key, words[i]);
  return v;
}

std::string xmlEscaped(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    const auto* const found = std::find_if(kEntities.begin(), kEntities.end(),
                                           [&](const auto& entity) { return entity.second == c; });
    if (found == kEntities.end())
      escaped += c;
    else
      escaped += found->first;
  }
  return escaped;
}

std::string xmlNumbers(std::span<const double> values) {
  std::string text;
  for (const double v : values) text += (text.empty() ? "" : " ") + formatDouble(v);
  return text;
}

std::string xmlNumbers(const Vector3d& v) { return xmlNumbers(std::span(v.data(), 3)); }

}  // namespace abstand::robot_file
