#include "core/robot_file/srdf_file.hpp"

#include <algorithm>
#include <set>

#include "core/base/text_file.hpp"
#include "core/robot_file/robot.hpp"
#include "core/robot_file/xml_values.hpp"

namespace abstand::robot_file {

Srdf parseSrdf(const std::string& text, const std::string& file) {
  const XmlElement robot = text::parseXml(text, file);
  const XmlValues values(file);
  if (robot.name != "robot")
    values.fail(robot, "found <" + std::string(robot.name.substr(0, 40)) + ">, expected <robot>: an SRDF");
  Srdf srdf;
  srdf.robot = values.text(robot, "name").value_or("");
  for (const auto& e : robot.children) {
    if (e.name == "link" || e.name == "joint")
      values.fail(e, "found <" + std::string(e.name) + ">, expected an SRDF",
                  "this is a URDF, which names the robot itself");
    if (e.name != "disable_collisions") continue;
    DisabledPair pair;
    pair.link1 = values.needText(e, "link1");
    pair.link2 = values.needText(e, "link2");
    pair.reason = values.text(e, "reason").value_or("");
    pair.pos = values.pos(e);
    if (pair.link1 == pair.link2)
      values.fail(e, "found a pair of " + pair.link1 + " with itself, expected two links");
    srdf.disabled.push_back(std::move(pair));
  }
  return srdf;
}

Srdf loadSrdf(const std::filesystem::path& file) {
  return parseSrdf(readFile(file, kMaxRobotBytes), file.string());
}

namespace {

std::string lineOf(const DisabledPair& pair) {
  return "  <disable_collisions link1=\"" + xmlEscaped(pair.link1) + "\" link2=\"" + xmlEscaped(pair.link2) +
         "\" reason=\"" + xmlEscaped(pair.reason) + "\"/>\n";
}

bool isSampled(std::string_view reason) {
  return reason == "Adjacent" || reason == "Never" || reason == "Always" || reason == "Default";
}

/// Range of an element in the document.
struct Span {
  std::size_t begin, end;
};

/// Range of the element, with its line if it is alone on it.
Span spanOf(const std::string& text, std::string_view name) {
  // `name` points into the document, just after its '<'.
  std::size_t begin = static_cast<std::size_t>(name.data() - text.data()) - 1;
  std::size_t end = begin;
  for (char quote = 0; end < text.size() && (quote != 0 || text[end] != '>'); ++end) {
    if (quote == 0 && (text[end] == '"' || text[end] == '\''))
      quote = text[end];
    else if (text[end] == quote)
      quote = 0;
  }
  if (text[end - 1] != '/') end = text.find('>', text.find("</disable_collisions", end));
  end = std::min(end + 1, text.size());
  std::size_t line = begin;
  while (line > 0 && (text[line - 1] == ' ' || text[line - 1] == '\t')) --line;
  std::size_t after = end;
  while (after < text.size() && (text[after] == ' ' || text[after] == '\t' || text[after] == '\r')) ++after;
  if ((line == 0 || text[line - 1] == '\n') && after < text.size() && text[after] == '\n')
    return {line, after + 1};
  return {begin, end};
}

}  // namespace

std::string srdfText(const Srdf& srdf) {
  std::string text = "<?xml version=\"1.0\"?>\n<robot name=\"" + xmlEscaped(srdf.robot) + "\">\n";
  for (const auto& pair : srdf.disabled) text += lineOf(pair);
  return text + "</robot>\n";
}

std::string mergedSrdfText(const std::string& old, const std::string& file, const Srdf& srdf) {
  const Srdf before = parseSrdf(old, file);
  if (before.robot != srdf.robot)
    throw ParseError(
        {file}, "found an SRDF of the robot '" + before.robot + "', expected one of '" + srdf.robot + "'",
        "choose another name for the output");
  const XmlElement robot = text::parseXml(old, file);
  std::set<std::pair<std::string, std::string>> kept;
  std::vector<Span> ours;
  std::size_t pair = 0;
  for (const auto& e : robot.children) {
    if (e.name != "disable_collisions") continue;
    const DisabledPair& known = before.disabled[pair++];
    if (isSampled(known.reason))
      ours.push_back(spanOf(old, e.name));
    else
      kept.insert(std::minmax(known.link1, known.link2));
  }
  std::string added;
  for (const auto& p : srdf.disabled)
    if (!kept.contains(std::minmax(p.link1, p.link2))) added += lineOf(p);
  // An empty root, `<robot name="x"/>`, has no end tag.
  const std::size_t end_tag = old.rfind("</robot");
  if (end_tag == std::string::npos) return srdfText(srdf);
  std::string text;
  std::size_t at = 0;
  for (const Span& span : ours) {
    text.append(old, at, span.begin - at);
    if (&span == &ours.front()) text += added;
    at = span.end;
  }
  if (!ours.empty()) return text.append(old, at);
  text.append(old, 0, end_tag);
  if (!text.empty() && text.back() != '\n') text += '\n';
  return text + added + old.substr(end_tag);
}

}  // namespace abstand::robot_file
