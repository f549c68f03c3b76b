#include "core/margin/margin_rules.hpp"

#include <algorithm>
#include <set>

#include "core/base/number.hpp"
#include "core/config/yaml_reader.hpp"

namespace abstand::margin {
namespace {

constexpr config::YamlRange kRuleMarginRange{0.0, 10.0, "m"};
constexpr config::YamlRange kRuleTimeRange{0.0, 10.0, "s"};

PairMargin pairMarginOf(const config::YamlFields& fields) {
  fields.need("margin");
  return {fields.number("margin", kRuleMarginRange).value_or(0.0),
          fields.number("robot_time", kRuleTimeRange).value_or(0.0),
          fields.number("person_time", kRuleTimeRange).value_or(0.0)};
}

MarginRule ruleOf(const config::YamlNode& node, const std::string& file,
                  const std::vector<std::string>& part_names) {
  const config::YamlFields fields(node, file, "a margin",
                                  {"part", "link", "margin", "robot_time", "person_time"});
  MarginRule rule{"", fields.text("link").value_or(""), pairMarginOf(fields)};
  if (fields.find("part")) rule.part = *fields.choice("part", part_names);
  if (rule.part.empty() && rule.link.empty())
    throw ParseError(fields.pos(),
                     "found a margin of neither a part nor a link, expected `part`, `link` or both");
  return rule;
}

std::string numbersText(const PairMargin& margin) {
  std::string text = "margin: " + formatDouble(margin.margin);
  if (margin.robot_time > 0.0) text += ", robot_time: " + formatDouble(margin.robot_time);
  if (margin.person_time > 0.0) text += ", person_time: " + formatDouble(margin.person_time);
  return text;
}

/// A YAML text in double quotes.
std::string yamlQuoted(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + "\"";
}

}  // namespace

std::optional<PairMargin> MarginRules::of(const std::string& part, const std::string& link) const {
  if (const auto own = classes.find(kMarginClasses.front()); own != classes.end())
    return PairMargin{own->second, 0.0, 0.0};
  std::optional<PairMargin> wide;
  for (const MarginRule& rule : rules) {
    if (rule.part == part && rule.link == link) return rule.margin;
    const bool fits = (rule.link.empty() && rule.part == part) || (rule.part.empty() && rule.link == link);
    if (!fits) continue;
    if (!wide) wide.emplace();
    const auto join = [this](double a, double b) { return sum ? a + b : std::max(a, b); };
    wide->margin = join(wide->margin, rule.margin.margin);
    wide->robot_time = join(wide->robot_time, rule.margin.robot_time);
    wide->person_time = join(wide->person_time, rule.margin.person_time);
  }
  return wide ? wide : other;
}

MarginRules parseMarginRules(const std::string& text, const std::string& file,
                             const std::vector<std::string>& part_names) {
  const config::YamlNode root = config::parseYaml(text, file);
  const config::YamlFields fields(root, file, "a set of margins",
                                  {"abstand_margins", "combine", "default", "margins", "classes"});
  const config::YamlNode& version = fields.need("abstand_margins");
  if (version.kind != config::YamlNode::Kind::kScalar || version.text != "1")
    throw ParseError(fields.pos(version), "found " + config::yamlFound(version) +
                                              " for `abstand_margins`, expected format version 1");
  MarginRules rules{file, {}, {}, false};
  rules.sum = fields.choice("combine", {"larger", "sum"}) == "sum";
  if (const config::YamlNode* other = fields.find("default"))
    rules.other = pairMarginOf(
        config::YamlFields(*other, file, "the default margin", {"margin", "robot_time", "person_time"}));
  if (const config::YamlNode* classes = fields.find("classes")) {
    const config::YamlFields numbers(*classes, file, "the margins of classes", kMarginClasses);
    for (const std::string& name : kMarginClasses)
      if (const auto margin = numbers.number(name, kRuleMarginRange)) rules.classes[name] = *margin;
  }
  std::set<std::pair<std::string, std::string>> seen;
  for (const config::YamlNode& node : fields.list("margins")) {
    rules.rules.push_back(ruleOf(node, file, part_names));
    const MarginRule& rule = rules.rules.back();
    if (!seen.insert({rule.part, rule.link}).second)
      throw ParseError({file, node.line, node.column},
                       "found a second margin for the same part and link, expected one");
  }
  if (rules.rules.empty() && !rules.other && rules.classes.empty())
    throw ParseError(fields.pos(), "found no margin, expected `default`, `margins` or `classes`");
  return rules;
}

std::string marginRulesText(const MarginRules& rules) {
  std::string text = "abstand_margins: 1\n";
  if (rules.sum) text += "combine: sum\n";
  if (rules.other) text += "default: {" + numbersText(*rules.other) + "}\n";
  if (!rules.rules.empty()) text += "margins:\n";
  for (const MarginRule& rule : rules.rules) {
    text += "  - {";
    if (!rule.part.empty()) text += "part: " + rule.part + ", ";
    if (!rule.link.empty()) text += "link: " + yamlQuoted(rule.link) + ", ";
    text += numbersText(rule.margin) + "}\n";
  }
  if (!rules.classes.empty()) text += "classes:\n";
  for (const auto& [name, margin] : rules.classes) text += "  " + name + ": " + formatDouble(margin) + "\n";
  return text;
}

}  // namespace abstand::margin
