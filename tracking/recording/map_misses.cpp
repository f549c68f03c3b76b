#include "tracking/recording/map_misses.hpp"

#include <algorithm>

#include "core/base/error.hpp"
#include "core/text/message_text.hpp"
#include "tracking/recording/name_index.hpp"

namespace abstand::tracking {
namespace {

constexpr std::size_t kMaxMisses = 8;  // in one sentence

/// True if more than half of two names is the same at their beginnings and ends: short names with a small
/// distance may share nothing.
bool isAlike(std::string_view a, std::string_view b) {
  const std::size_t shorter = std::min(a.size(), b.size());
  std::size_t begin = 0, end = 0;
  while (begin < shorter && a[begin] == b[begin]) ++begin;
  while (end < shorter - begin && a[a.size() - 1 - end] == b[b.size() - 1 - end]) ++end;
  return 2 * (begin + end) > std::max(a.size(), b.size());
}

/// 'NAME', or 'NAME' (nearest: 'OTHER').
std::string missOf(const std::string& wanted, std::span<const std::string> names) {
  std::vector<std::string> plain;
  const auto bare = [](std::string_view name) { return plainName(name.substr(name.rfind(':') + 1)); };
  for (const std::string& name : names) plain.push_back(bare(name));
  const std::string quoted = text::inQuotes(wanted);
  const std::string near = nearestName(bare(wanted), plain);
  for (std::size_t i = 0; i < names.size(); ++i)
    if (!near.empty() && plain[i] == near && isAlike(bare(wanted), near))
      return quoted + " (nearest: " + text::inQuotes(names[i]) + ")";
  return quoted;
}

/// Why an entry of a map, a name or a sum of names, has no match.
std::string missOf(const std::string& wanted, const NameIndex& index, std::span<const std::string> names) {
  for (const std::string& name : isSum(wanted) ? namesOfSum(wanted) : std::vector{wanted})
    if (index.find(name) < 0) return missOf(name, names);
  return text::inQuotes(wanted) + " (used for another joint)";
}

}  // namespace

std::string missesOf(const JointMap& map, const JointMatch& match, std::span<const std::string> names) {
  const NameIndex index(names, map.prefixes);
  for (const std::string& name : map.required)
    if (index.find(name) < 0)
      return "the joint map requires " + missOf(name, names) +
             ", which the file does not have: it maps nothing";
  std::string misses;
  std::size_t count = 0;
  for (std::size_t j = 0; j < humanmodel::kJointCount; ++j) {
    if (map.names[j].empty() || match.joint[j] >= 0) continue;
    ++count;
    if (count > kMaxMisses) continue;
    misses += (misses.empty() ? "" : ", ") +
              std::string(humanmodel::jointName(static_cast<humanmodel::Joint>(j))) + " " +
              missOf(map.names[j].front(), index, names);
  }
  if (count > kMaxMisses) misses += ", and " + std::to_string(count - kMaxMisses) + " more";
  return misses.empty() ? misses : "the joint map names joints that the file does not have: " + misses;
}

}  // namespace abstand::tracking
