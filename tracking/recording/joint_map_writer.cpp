#include "tracking/recording/joint_map_writer.hpp"

#include <algorithm>

#include "core/base/error.hpp"
#include "core/base/message_line.hpp"
#include "core/text/message_text.hpp"
#include "tracking/recording/joint_map.hpp"

namespace abstand::tracking {
namespace {

/// A name as it stands in a map; in double quotes if it has a bar or begins with a quote.
std::string writtenName(const std::string& name) {
  const bool is_plain = name.find('|') == std::string::npos && !name.starts_with('"');
  return is_plain ? name : '"' + name + '"';
}

/// Points of a match for one joint, by name.
std::vector<std::string> namesOf(const JointMatch& match, std::size_t joint,
                                 const std::vector<std::string>& names) {
  const int i = match.joint[joint];
  if (i < 0) return {};
  if (static_cast<std::size_t>(i) < names.size()) return {names[static_cast<std::size_t>(i)]};
  std::vector<std::string> sum;
  for (const int point : match.means[static_cast<std::size_t>(i) - names.size()])
    sum.push_back(names[static_cast<std::size_t>(point)]);
  return sum;
}

/// Throws UsageError if the map does not find the same joints.
void checkMap(const std::string& text, const RecordingReport& report) {
  const auto fail = [](const std::string& what) {
    throw UsageError("write-map: found " + what + ", expected names that a joint map can distinguish");
  };
  JointMatch match;
  try {
    match = matchJoints(parseJointMap(text, "map"), report.joints);
  } catch (const ParseError& e) {
    fail("names that do not fit into a joint map (" + e.message() + ")");
  }
  for (std::size_t j = 0; j < humanmodel::kJointCount; ++j) {
    if (namesOf(match, j, report.joints) == report.map_use.names[j]) continue;
    const std::string& name = report.map_use.names[j].front();
    const bool is_twice = std::ranges::count(report.joints, name) > 1;
    fail("the name " + text::inQuotes(name) +
         (is_twice ? " more than once in the file" : ", which a joint map cannot state"));
  }
}

/// The lines of a map for the joints that are known.
std::string jointLines(const RecordingReport& report, std::string_view before_unknown) {
  std::string text = std::string("head_is: ") + (report.map_use.head_is_middle ? "middle" : "base") + "\n";
  if (report.map_use.of_markers) text += "points: markers\n";
  for (std::size_t j = 0; j < humanmodel::kJointCount; ++j) {
    std::string sum;
    for (const std::string& name : report.map_use.names[j])
      sum += (sum.empty() ? "" : " + ") + writtenName(name);
    const std::string key(humanmodel::jointName(static_cast<humanmodel::Joint>(j)));
    if (!sum.empty())
      text += key + ": " + sum + "\n";
    else if (!before_unknown.empty())
      text += std::string(before_unknown) + key + ":\n";
  }
  return text;
}

std::string mapToFillIn(const RecordingReport& report) {
  std::string text =
      "# Written by abstand skeleton --write-map: set names of the file after the joints that it has, and "
      "remove\n"
      "# the '#' before them. A part moves if the joints at both of its ends are known.\nname: own\n";
  text += jointLines(report, "# ");
  text += "# Names in the file:\n";
  for (const std::string& name : report.joints) text += "#   " + messageLine(writtenName(name)) + "\n";
  return text;
}

/// A map to fill in, with the joints that were found if a map can state their names.
std::string templateOf(const RecordingReport& report) {
  std::string text = mapToFillIn(report);
  try {
    checkMap(text, report);
  } catch (const UsageError&) {
    RecordingReport bare = report;
    bare.map_use.names = {};
    text = mapToFillIn(bare);
  }
  return text;
}

}  // namespace

std::string jointMapText(const RecordingReport& report) {
  if (!report.markers.set.empty())
    throw UsageError("write-map: found markers that were solved by the marker set '" + report.markers.set +
                     "', expected joints by a joint map (--marker-set none)");
  if (report.mapped.empty()) return templateOf(report);
  std::string text = "# Written by abstand skeleton --write-map.\nname: ";
  text += report.joint_map.empty() ? "canonical names" : report.joint_map;
  text += "\n" + jointLines(report, "");
  checkMap(text, report);
  return text;
}

}  // namespace abstand::tracking
