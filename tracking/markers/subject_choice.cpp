#include "tracking/markers/subject_choice.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "core/base/data_folder.hpp"
#include "core/text/message_text.hpp"
#include "tracking/markers/marker_set.hpp"
#include "tracking/recording/joint_map.hpp"
#include "tracking/recording/name_index.hpp"

namespace abstand::tracking {
namespace {

/// Others that a warning names one by one.
constexpr std::size_t kNamedOthers = 5;

struct LabelGroup {
  std::string prefix;
  std::size_t known{0}, labels{0};
};

std::string prefixOf(const std::string& name) {
  const auto colon = name.rfind(':');
  return colon == std::string::npos ? std::string() : name.substr(0, colon);
}

std::string bareOf(const std::string& name) {
  const auto colon = name.rfind(':');
  return plainName(colon == std::string::npos ? name : name.substr(colon + 1));
}

void addNames(const std::vector<std::string>& names, std::set<std::string>& known) {
  for (const std::string& name : names) {
    std::size_t from = 0;
    for (auto plus = name.find(" + "); plus != std::string::npos; plus = name.find(" + ", from)) {
      known.insert(plainName(name.substr(from, plus - from)));
      from = plus + 3;
    }
    known.insert(plainName(name.substr(from)));
  }
}

/// Normal forms of the labels in marker sets and joint maps.
std::set<std::string> knownLabels(const RecordingOptions& options) {
  std::set<std::string> known;
  const bool is_own_set = options.marker_set != "auto" && options.marker_set != "none";
  const auto sets = is_own_set ? std::vector<MarkerSet>{loadMarkerSet(options.marker_set)}
                               : loadMarkerSets(dataFolder() / "marker_sets");
  for (const MarkerSet& set : sets)
    for (const SetMarker& marker : set.markers) addNames(marker.names, known);
  const auto maps = options.joint_map.empty() ? loadJointMaps(dataFolder() / "joint_maps")
                                              : std::vector<JointMap>{loadJointMap(options.joint_map)};
  for (const JointMap& map : maps)
    for (const auto& names : map.names) addNames(names, known);
  return known;
}

std::string described(const LabelGroup& group) {
  return (group.prefix.empty() ? "without a prefix" : text::inQuotes(group.prefix)) + " (" +
         std::to_string(group.labels) + (group.labels == 1 ? " marker)" : " markers)");
}

/// Names the groups that are not used; points without a prefix are no subject if no label is known.
std::string warningOfOthers(const std::vector<LabelGroup>& groups, const LabelGroup& used) {
  std::string others;
  std::size_t count = 0;
  for (const LabelGroup& group : groups) {
    if (&group == &used || (group.prefix.empty() && group.known == 0)) continue;
    if (++count <= kNamedOthers) others += (count > 1 ? ", " : "") + described(group);
  }
  if (count == 0) return {};
  if (count > kNamedOthers) others += " and " + std::to_string(count - kNamedOthers) + " more";
  return "the file has markers of several subjects: those of " + described(used) + " are used; those of " +
         others + " are ignored, and no distance to them is known";
}

}  // namespace

SubjectChoice chooseSubject(std::span<const std::string> names, const RecordingOptions& options) {
  SubjectChoice choice;
  choice.names.assign(names.begin(), names.end());
  std::vector<LabelGroup> groups;
  std::map<std::string, std::size_t> of_prefix;
  for (const std::string& name : names)
    if (of_prefix.emplace(prefixOf(name), groups.size()).second) groups.push_back({prefixOf(name)});
  if (groups.empty()) return choice;
  choice.prefix = groups.front().prefix;
  if (groups.size() == 1) return choice;

  const std::set<std::string> known = knownLabels(options);
  for (const std::string& name : names) {
    LabelGroup& group = groups[of_prefix.at(prefixOf(name))];
    ++group.labels;
    if (known.contains(bareOf(name)) || known.contains(plainName(name))) ++group.known;
  }
  const auto used = std::max_element(groups.begin(), groups.end(), [](const auto& a, const auto& b) {
    return std::tie(a.known, a.labels) < std::tie(b.known, b.labels);
  });
  choice.prefix = used->prefix;
  for (std::string& name : choice.names) {
    const std::string prefix = prefixOf(name);
    const bool is_named = !prefix.empty() && known.contains(plainName(name));
    if (prefix != used->prefix && !is_named) name.clear();
  }
  choice.warning = warningOfOthers(groups, *used);
  return choice;
}

StatedSubject statedOf(const SubjectChoice& choice, std::span<const StatedSubject> subjects) {
  const auto is = [&](const std::string& name) {
    const auto end = name.find_last_not_of(": ");
    return end != std::string::npos && plainName(name.substr(0, end + 1)) == plainName(choice.prefix);
  };
  for (const StatedSubject& subject : subjects)
    if (is(subject.label_prefix) || is(subject.facts.name)) return subject;
  if (subjects.empty() || (!choice.warning.empty() && !choice.prefix.empty())) return {};
  StatedSubject first = subjects.front();
  if (subjects.size() > 1)
    first.warnings.push_back(
        "the file names " + std::to_string(subjects.size()) +
        " subjects, but its labels do not say whose they are: they are taken as those of " +
        text::inQuotes(first.facts.name));
  return first;
}

}  // namespace abstand::tracking
