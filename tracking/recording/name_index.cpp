#include "tracking/recording/name_index.hpp"

#include "core/text/message_text.hpp"

namespace abstand::tracking {
namespace {

constexpr std::string_view kPlus = " + ";

}  // namespace

std::string_view trimmed(std::string_view s) { return text::trimmed(s, " \t", " \t\r"); }

std::vector<std::string> namesBetweenBars(std::string_view list, const SourcePos& pos) {
  std::vector<std::string> out;
  while (true) {
    list = trimmed(list);
    const bool is_quoted = list.starts_with('"') && list.find('"', 1) != std::string_view::npos;
    const auto bar = list.find('|', is_quoted ? list.find('"', 1) : 0);
    auto name = trimmed(list.substr(0, bar));
    if (is_quoted && name.size() >= 2 && name.find('"', 1) + 1 == name.size())
      name = name.substr(1, name.size() - 2);
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
