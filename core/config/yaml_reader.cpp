#include "core/config/yaml_reader.hpp"

#include <algorithm>

#include "core/base/number.hpp"

namespace abstand::config {
namespace {

/// Quotes untrusted text for messages, shortened if long.
std::string quoted(const std::string& text) {
  constexpr std::size_t kShown = 60;
  return "`" + (text.size() > kShown ? text.substr(0, kShown) + "..." : text) + "`";
}

std::string oneOf(const std::vector<std::string>& names) {
  std::string s = "one of ";
  for (std::size_t i = 0; i < names.size(); ++i) s += (i ? ", " : "") + names[i];
  return s;
}

std::string label(std::string_view key) { return "`" + std::string(key) + "`"; }

int yamlInteger(const YamlNode& node, const std::string& file, const std::string& label, int min, int max) {
  const SourcePos pos{file, node.line, node.column};
  const auto value =
      node.kind == YamlNode::Kind::kScalar && !node.quoted ? parseInt(node.text) : std::nullopt;
  if (!value || *value < min || *value > max)
    throw ParseError(pos, "found " + yamlFound(node) + " for " + label + ", expected a whole number from " +
                              std::to_string(min) + " to " + std::to_string(max));
  return *value;
}

}  // namespace

std::string nearestHint(const std::string& name, const std::vector<std::string>& known) {
  const auto nearest = nearestName(name, known);
  return nearest.empty() ? std::string{} : "did you mean `" + nearest + "`?";
}

std::string yamlFound(const YamlNode& node) {
  switch (node.kind) {
    case YamlNode::Kind::kMap:
      return "a map";
    case YamlNode::Kind::kList:
      return "a list";
    case YamlNode::Kind::kScalar:
      return node.quoted ? "the text " + quoted(node.text) : quoted(node.text);
    case YamlNode::Kind::kNothing:
      break;
  }
  return "nothing";
}

double yamlNumber(const YamlNode& node, const std::string& file, const std::string& label,
                  const YamlRange& range) {
  const SourcePos pos{file, node.line, node.column};
  const auto value =
      node.kind == YamlNode::Kind::kScalar && !node.quoted ? parseDouble(node.text) : std::nullopt;
  if (!value)
    throw ParseError(pos, "found " + yamlFound(node) + " for " + label + ", expected a finite number");
  if (*value < range.min || *value > range.max || (range.above && *value <= range.min)) {
    const std::string unit = *range.unit ? std::string(" ") + range.unit : "";
    throw ParseError(pos, "found " + yamlFound(node) + " for " + label + ", expected a number " +
                              (range.above ? "above " : "from ") + formatDouble(range.min) +
                              (range.above ? " and at most " : " to ") + formatDouble(range.max) + unit);
  }
  return *value;
}

std::string yamlText(const YamlNode& node, const std::string& file, const std::string& label) {
  if (node.kind != YamlNode::Kind::kScalar || node.text.empty() || node.text.size() > kMaxYamlText)
    throw ParseError({file, node.line, node.column}, "found " + yamlFound(node) + " for " + label +
                                                         ", expected 1 to " + std::to_string(kMaxYamlText) +
                                                         " characters");
  // Escapes in quoted scalars can produce control characters that the raw text may not contain.
  if (std::any_of(node.text.begin(), node.text.end(),
                  [](char c) { return static_cast<unsigned char>(c) < 0x20; }))
    throw ParseError({file, node.line, node.column},
                     "found a control character or a line break in " + label + ", expected one line of text");
  return node.text;
}

std::string yamlChoice(const YamlNode& node, const std::string& file, const std::string& label,
                       const std::vector<std::string>& choices) {
  if (node.kind == YamlNode::Kind::kScalar &&
      std::find(choices.begin(), choices.end(), node.text) != choices.end())
    return node.text;
  throw ParseError({file, node.line, node.column},
                   "found " + yamlFound(node) + " for " + label + ", expected " + oneOf(choices),
                   nearestHint(node.text, choices));
}

const std::vector<YamlNode>& yamlList(const YamlNode& node, const std::string& file,
                                      const std::string& label) {
  if (node.kind != YamlNode::Kind::kList)
    throw ParseError({file, node.line, node.column},
                     "found " + yamlFound(node) + " for " + label + ", expected a list");
  return node.items;
}

YamlFields::YamlFields(const YamlNode& node, const std::string& file, std::string what,
                       std::vector<std::string> known)
    : node_{node}, file_{file}, what_{std::move(what)} {
  if (node.kind != YamlNode::Kind::kMap)
    throw ParseError(pos(), "found " + yamlFound(node) + " for " + what_ + ", expected a map");
  for (const auto& key : node.keys) {
    if (std::find(known.begin(), known.end(), key.text) != known.end()) continue;
    throw ParseError(
        {file, key.line, key.column},
        "found the unknown key " + quoted(key.text) + " in " + what_ + ", expected " + oneOf(known),
        nearestHint(key.text, known));
  }
}

const YamlNode* YamlFields::find(std::string_view key) const {
  for (std::size_t i = 0; i < node_.keys.size(); ++i)
    if (node_.keys[i].text == key) return &node_.items[i];
  return nullptr;
}

const YamlNode& YamlFields::need(std::string_view key) const {
  if (const auto* value = find(key)) return *value;
  throw ParseError(pos(), "found no " + label(key) + " in " + what_ + ", expected one");
}

SourcePos YamlFields::keyPos(std::string_view key) const {
  for (const auto& k : node_.keys)
    if (k.text == key) return {file_, k.line, k.column};
  return pos();
}

std::optional<double> YamlFields::number(std::string_view key, const YamlRange& range) const {
  const auto* value = find(key);
  return value ? std::optional{yamlNumber(*value, file_, label(key), range)} : std::nullopt;
}

std::optional<int> YamlFields::integer(std::string_view key, int min, int max) const {
  const auto* value = find(key);
  return value ? std::optional{yamlInteger(*value, file_, label(key), min, max)} : std::nullopt;
}

std::optional<std::string> YamlFields::text(std::string_view key) const {
  const auto* value = find(key);
  return value ? std::optional{yamlText(*value, file_, label(key))} : std::nullopt;
}

std::optional<std::string> YamlFields::choice(std::string_view key,
                                              const std::vector<std::string>& choices) const {
  const auto* value = find(key);
  return value ? std::optional{yamlChoice(*value, file_, label(key), choices)} : std::nullopt;
}

std::optional<Vector3d> YamlFields::vector(std::string_view key, const YamlRange& range) const {
  const auto* value = find(key);
  if (!value) return std::nullopt;
  if (value->kind != YamlNode::Kind::kList || value->items.size() != 3)
    throw ParseError(pos(*value), "found " +
                                      (value->kind == YamlNode::Kind::kList
                                           ? "a list of " + std::to_string(value->items.size())
                                           : yamlFound(*value)) +
                                      " for " + label(key) + ", expected a list of 3 numbers");
  Vector3d v;
  for (int i = 0; i < 3; ++i)
    v[i] = yamlNumber(value->items[static_cast<std::size_t>(i)], file_, label(key), range);
  return v;
}

const std::vector<YamlNode>& YamlFields::list(std::string_view key) const {
  static const std::vector<YamlNode> none;
  const auto* value = find(key);
  return value ? yamlList(*value, file_, label(key)) : none;
}

}  // namespace abstand::config
