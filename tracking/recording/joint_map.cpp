#include "tracking/recording/joint_map.hpp"

#include <algorithm>
#include <tuple>

#include "core/base/error.hpp"
#include "core/base/text_file.hpp"
#include "core/text/message_text.hpp"
#include "tracking/recording/name_index.hpp"

namespace abstand::tracking {
namespace {

constexpr std::uintmax_t kMaxMapBytes = 1 << 20;

/// Index of `value` in two words.
int oneOf(std::string_view value, std::array<const char*, 2> words, const SourcePos& pos) {
  for (int i = 0; i < 2; ++i)
    if (value == words[static_cast<std::size_t>(i)]) return i;
  throw ParseError(pos, "found " + text::inQuotes(value) + ", expected " + words[0] + " or " + words[1]);
}

}  // namespace

JointMap parseJointMap(std::string_view text, const std::filesystem::path& file) {
  JointMap map;
  map.file = file;
  std::vector<std::string> keys{"name", "origin", "licence", "prefix", "requires", "head_is", "points"};
  for (std::size_t j = 0; j < humanmodel::kJointCount; ++j)
    keys.emplace_back(humanmodel::jointName(static_cast<humanmodel::Joint>(j)));

  SourcePos pos{file.string()};
  for (std::size_t from = 0; from < text.size();) {
    ++pos.line;
    const auto to = std::min(text.find('\n', from), text.size());
    const auto line = trimmed(text.substr(from, to - from));
    from = to + 1;
    if (line.empty() || line.front() == '#') continue;
    const auto colon = line.find(':');
    if (colon == std::string_view::npos)
      throw ParseError(pos, "found " + text::inQuotes(line) + ", expected 'key: name | name ...'");
    const std::string key(trimmed(line.substr(0, colon)));
    const auto value = trimmed(line.substr(colon + 1));
    if (key == "name")
      map.name = value;
    else if (key == "origin")
      map.origin = value;
    else if (key == "licence")
      map.licence = value;
    else if (key == "prefix")
      map.prefixes = namesBetweenBars(value, pos);
    else if (key == "requires")
      map.required = namesBetweenBars(value, pos);
    else if (key == "head_is")
      map.head = oneOf(value, {"base", "middle"}, pos) == 0 ? HeadPoint::kBase : HeadPoint::kMiddle;
    else if (key == "points")
      map.of_markers = oneOf(value, {"joints", "markers"}, pos) == 1;
    else if (const auto joint = humanmodel::parseJoint(key)) {
      auto& names = map.names[static_cast<std::size_t>(*joint)];
      if (!names.empty())
        throw ParseError(pos, "found " + text::inQuotes(key) + " a second time, expected it once");
      names = namesBetweenBars(value, pos);
    } else {
      const auto near = nearestName(key, keys);
      throw ParseError(
          pos,
          "found " + text::inQuotes(key) +
              ", expected a canonical joint or name, origin, licence, prefix, requires, head_is, "
              "points",
          near.empty() ? "" : "did you mean '" + near + "'?");
    }
  }
  if (map.name.empty()) throw ParseError({file.string()}, "found no 'name:' line, expected the map's name");
  return map;
}

JointMap loadJointMap(const std::filesystem::path& file) {
  return parseJointMap(readFile(file, kMaxMapBytes), file);
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
  const NameIndex index(names, map.prefixes);
  for (const auto& name : map.required) {
    if (index.find(name) < 0) return match;
    ++match.specific;
  }
  std::vector<bool> used(names.size(), false);
  for (std::size_t j = 0; j < humanmodel::kJointCount; ++j) {
    for (std::size_t rank = 0; rank < map.names[j].size() && match.joint[j] < 0; ++rank) {
      const std::string& wanted = map.names[j][rank];
      if (isSum(wanted) && index.find(wanted) < 0) {
        auto points = index.points(wanted);
        if (points.empty()) continue;
        match.joint[j] = static_cast<int>(names.size() + match.means.size());
        match.means.push_back(std::move(points));
      } else {
        const int point = index.find(wanted);
        if (point < 0 || used[static_cast<std::size_t>(point)]) continue;
        used[static_cast<std::size_t>(point)] = true;
        match.joint[j] = point;
      }
      match.rank += static_cast<int>(rank);
      ++match.mapped;
    }
    if (!map.names[j].empty() && match.joint[j] < 0) ++match.not_found;
  }
  const auto has_prefix = [&](int joint) {
    return joint >= 0 && static_cast<std::size_t>(joint) < names.size() &&
           std::any_of(map.prefixes.begin(), map.prefixes.end(), [&](const std::string& prefix) {
             return plainName(names[static_cast<std::size_t>(joint)]).starts_with(plainName(prefix));
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

}  // namespace abstand::tracking
