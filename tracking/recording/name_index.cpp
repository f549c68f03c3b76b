#include "tracking/recording/name_index.hpp"

#include "core/text/message_text.hpp"

namespace abstand::tracking {
namespace {

constexpr std::string_view kPlus = " + ";

/// Place of the quote that ends the name in quotes at the start of a list: the first that a bar or the end
/// follows, as names may contain quotes. npos: none.
std::size_t closingQuote(std::string_view list) {
  if (!list.starts_with('"')) return list.npos;
  for (auto quote = list.find('"', 1); quote != list.npos; quote = list.find('"', quote + 1)) {
    const auto next = list.find_first_not_of(" \t", quote + 1);
    if (next == list.npos || list[next] == '|') return quote;
  }
  return list.npos;
}

}  // namespace

std::string_view trimmed(std::string_view s) { return text::trimmed(s, " \t", " \t\r"); }

std::vector<std::string> namesBetweenBars(std::string_view list, const SourcePos& pos) {
  std::vector<std::string> out;
  while (true) {
    list = trimmed(list);
    const std::size_t closing = closingQuote(list);
    const auto bar = list.find('|', closing == list.npos ? 0 : closing);
    const auto name = closing == list.npos ? trimmed(list.substr(0, bar)) : list.substr(1, closing - 1);
    if (name.empty()) throw ParseError(pos, "found an empty name, expected 'name | name ...'");
    out.emplace_back(name);
    if (bar == std::string_view::npos) return out;
    list.remove_prefix(bar + 1);
  }
}

std::string plainName(std::string_view name) {
  std::string s = text::lowerCase(trimmed(name));
  for (char& c : s)
    if (c == '_' || c == '.' || c == '-') c = ' ';
  return s;
}

NameIndex::NameIndex(std::span<const std::string> names, std::span<const std::string> prefixes) {
  for (std::size_t i = 0; i < names.size(); ++i) exact_.emplace(trimmed(names[i]), static_cast<int>(i));
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string full = plainName(names[i]);
    const std::string bare = plainName(std::string_view(full).substr(full.rfind(':') + 1));
    for (const std::string& form : {full, bare}) {
      index_.emplace(form, static_cast<int>(i));
      for (const auto& prefix : prefixes)
        if (const auto p = plainName(prefix); form.size() > p.size() && form.starts_with(p))
          index_.emplace(plainName(std::string_view(form).substr(p.size())), static_cast<int>(i));
    }
  }
}

int NameIndex::find(std::string_view name) const {
  if (const auto exact = exact_.find(std::string(trimmed(name))); exact != exact_.end()) return exact->second;
  const auto it = index_.find(plainName(name));
  return it == index_.end() ? -1 : it->second;
}

std::vector<int> NameIndex::points(std::string_view sum) const {
  std::vector<int> points;
  for (const std::string& name : namesOfSum(sum)) {
    points.push_back(find(name));
    if (points.back() < 0) return {};
  }
  return points;
}

bool isSum(std::string_view name) { return name.find(kPlus) != std::string_view::npos; }

std::vector<std::string> namesOfSum(std::string_view sum) {
  std::vector<std::string> names;
  while (true) {
    const auto plus = sum.find(kPlus);
    names.emplace_back(sum.substr(0, plus));
    if (plus == std::string_view::npos) return names;
    sum.remove_prefix(plus + kPlus.size());
  }
}

}  // namespace abstand::tracking
