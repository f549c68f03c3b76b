#include "tracking/joint_map.hpp"

#include <algorithm>
#include <tuple>
#include <unordered_map>

#include "core/base/error.hpp"
#include "core/base/text_file.hpp"
#include "tracking/message_text.hpp"

namespace abstand {
namespace {

constexpr std::uintmax_t kMostMapBytes = 1 << 20;
constexpr std::string_view kPlus = " + ";

std::string_view trimmed(std::string_view s) {
  while (!s.empty() && (s.front() == ' ' || s.front() == '\t')) s.remove_prefix(1);
  while (!s.empty() && (s.back() == ' ' || s.back() == '\t' || s.back() == '\r')) s.remove_suffix(1);
  return s;
}

std::vector<std::string> alternatives(std::string_view list, const SourcePos& pos) {
  std::vector<std::string> out;
  while (true) {
    const auto bar = list.find('|');
    const auto name = trimmed(list.substr(0, bar));
    if (name.empty()) throw ParseError(pos, "found an empty name, expected 'key: name | name ...'");
    out.emplace_back(name);
    if (bar == std::string_view::npos) return out;
    list.remove_prefix(bar + 1);
  }
}

/// The place of `value` among two words.
int oneOf(std::string_view value, std::array<const char*, 2> words, const SourcePos& pos) {
  for (int i = 0; i < 2; ++i)
    if (value == words[static_cast<std::size_t>(i)]) return i;
  throw ParseError(pos, "found " + inQuotes(value) + ", expected " + words[0] + " or " + words[1]);
}

/// The form in which names are compared.
std::string plain(std::string_view name) {
  std::string s = lowerCase(trimmed(name));
  for (char& c : s)
    if (c == '_' || c == '.' || c == '-') c = ' ';
  return s;
}

std::string withoutNamespace(const std::string& plain_name) {
  return plain(std::string_view(plain_name).substr(plain_name.rfind(':') + 1));
}

/// The first joint of the file by each form of its name that this map may look for.
std::unordered_map<std::string, int> indexNames(const JointMap& map, std::span<const std::string> names) {
  std::unordered_map<std::string, int> index;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string full = plain(names[i]);
    for (const std::string& form : {full, withoutNamespace(full)}) {
      index.emplace(form, static_cast<int>(i));
      for (const auto& prefix : map.prefixes)
        if (const auto p = plain(prefix); form.size() > p.size() && form.starts_with(p))
          index.emplace(plain(std::string_view(form).substr(p.size())), static_cast<int>(i));
    }
  }
  return index;
}

/// The points of "A + B + C", or empty where one of them is not in the file.
std::vector<int> pointsOfMean(std::string_view sum, const std::unordered_map<std::string, int>& index) {
  std::vector<int> points;
  while (true) {
    const auto plus = sum.find(kPlus);
    const auto it = index.find(plain(sum.substr(0, plus)));
    if (it == index.end()) return {};
    points.push_back(it->second);
    if (plus == std::string_view::npos) return points;
    sum.remove_prefix(plus + kPlus.size());
  }
}

}  // namespace

JointMap parseJointMap(std::string_view text, const std::filesystem::path& file) {
  JointMap map;
  map.file = file;
  std::vector<std::string> keys{"name", "origin", "licence", "prefix", "requires", "head_is", "points"};
  for (std::size_t j = 0; j < kJointCount; ++j) keys.emplace_back(jointName(static_cast<Joint>(j)));

  SourcePos pos{file.string()};
  for (std::size_t from = 0; from < text.size();) {
    ++pos.line;
    const auto to = std::min(text.find('\n', from), text.size());
    const auto line = trimmed(text.substr(from, to - from));
    from = to + 1;
    if (line.empty() || line.front() == '#') continue;
    const auto colon = line.find(':');
    if (colon == std::string_view::npos)
      throw ParseError(pos, "found " + inQuotes(line) + ", expected 'key: name | name ...'");
    const std::string key(trimmed(line.substr(0, colon)));
    const auto value = trimmed(line.substr(colon + 1));
    if (key == "name")
      map.name = value;
    else if (key == "origin")
      map.origin = value;
    else if (key == "licence")
      map.licence = value;
    else if (key == "prefix")
      map.prefixes = alternatives(value, pos);
    else if (key == "requires")
      map.required = alternatives(value, pos);
    else if (key == "head_is")
      map.head = oneOf(value, {"base", "middle"}, pos) == 0 ? HeadPoint::kBase : HeadPoint::kMiddle;
    else if (key == "points")
      map.of_markers = oneOf(value, {"joints", "markers"}, pos) == 1;
    else if (const auto joint = parseJoint(key)) {
      auto& names = map.names[static_cast<std::size_t>(*joint)];
      if (!names.empty())
        throw ParseError(pos, "found " + inQuotes(key) + " a second time, expected it once");
      names = alternatives(value, pos);
    } else {
      const auto near = nearestName(key, keys);
      throw ParseError(
          pos,
          "found " + inQuotes(key) +
              ", expected a canonical joint or name, origin, licence, prefix, requires, head_is, "
              "points",
          near.empty() ? "" : "did you mean '" + near + "'?");
    }
  }
  if (map.name.empty()) throw ParseError({file.string()}, "found no 'name:' line, expected the map's name");
  return map;
}

JointMap loadJointMap(const std::filesystem::path& file) {
  return parseJointMap(readFile(file, kMostMapBytes), file);
}

std::vector<JointMap> loadJointMaps(const std::filesystem::path& folder) {
  namespace fs = std::filesystem;
  std::vector<fs::path> files;
  std::error_code ec;
  for (fs::directory_iterator it(folder, ec), end; !ec && it != end; it.increment(ec))
    if (it->path().extension() == ".map") files.push_back(it->path());
  if (files.empty())
    throw ParseError({folder.string()}, "found no joint maps, expected *.map files",
                     "the environment variable ABSTAND_DATA may name the folder that holds joint_maps");
  std::sort(files.begin(), files.end());
  std::vector<JointMap> maps;
  for (const auto& file : files) maps.push_back(loadJointMap(file));
  return maps;
}

JointMatch matchJoints(const JointMap& map, std::span<const std::string> names) {
  JointMatch match;
  match.map = map.name;
  match.head = map.head;
  match.of_markers = map.of_markers;
  match.joint.fill(-1);
  const auto index = indexNames(map, names);
  for (const auto& name : map.required) {
    if (!index.contains(plain(name))) return match;
    ++match.specific;
  }
  std::vector<bool> used(names.size(), false);
  for (std::size_t j = 0; j < kJointCount; ++j) {
    for (std::size_t rank = 0; rank < map.names[j].size() && match.joint[j] < 0; ++rank) {
      const std::string& wanted = map.names[j][rank];
      if (wanted.find(kPlus) != std::string::npos) {
        auto points = pointsOfMean(wanted, index);
        if (points.empty()) continue;
        match.joint[j] = static_cast<int>(names.size() + match.means.size());
        match.means.push_back(std::move(points));
      } else {
        const auto it = index.find(plain(wanted));
        if (it == index.end() || used[static_cast<std::size_t>(it->second)]) continue;
        used[static_cast<std::size_t>(it->second)] = true;
        match.joint[j] = it->second;
      }
      match.rank += static_cast<int>(rank);
      ++match.mapped;
    }
    if (!map.names[j].empty() && match.joint[j] < 0) ++match.not_found;
  }
  const auto has_prefix = [&](int joint) {
    return joint >= 0 && static_cast<std::size_t>(joint) < names.size() &&
           std::any_of(map.prefixes.begin(), map.prefixes.end(), [&](const std::string& prefix) {
             return plain(names[static_cast<std::size_t>(joint)]).starts_with(plain(prefix));
           });
  };
  if (!map.prefixes.empty())
    match.specific += std::any_of(match.joint.begin(), match.joint.end(), has_prefix) ? 1 : -1;
  return match;
}

JointMatch chooseJointMap(std::span<const JointMap> maps, std::span<const std::string> names) {
  ABSTAND_CHECK(!maps.empty());
  JointMatch best;
  const auto key = [](const JointMatch& m) {
    return std::tuple(-m.mapped, -m.specific, m.rank, m.not_found);
  };
  bool first = true;
  for (const auto& map : maps) {
    auto match = matchJoints(map, names);
    if (first || key(match) < key(best)) best = std::move(match);
    first = false;
  }
  return best;
}

}  // namespace abstand
