// Typed values from a YAML tree; every error has its position.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/config/yaml_document.hpp"
#include "core/math/transform.hpp"

namespace abstand::config {

/// Allowed range: least <= x <= most, or least < x <= most with `above`.
struct YamlRange {
  double min, max;
  const char* unit{""};
  bool above{false};
};

/// A map of a scene file with a fixed set of keys. `what` names it in messages ("an object"). Getters return
/// nullopt or null for an absent key and throw ParseError at the value for another type or a value out of
/// range.
class YamlFields {
 public:
  /// Throws ParseError if the node is not a map or has a key that is not in `known`.
  YamlFields(const YamlNode& node, const std::string& file, std::string what, std::vector<std::string> known);

  const YamlNode* find(std::string_view key) const;
  /// Throws ParseError at the map if the key is absent.
  const YamlNode& need(std::string_view key) const;

  std::optional<double> number(std::string_view key, const YamlRange& range) const;
  std::optional<int> integer(std::string_view key, int min, int max) const;
  std::optional<std::string> text(std::string_view key) const;
  /// The value, which must be one of `choices`.
  std::optional<std::string> choice(std::string_view key, const std::vector<std::string>& choices) const;
  std::optional<Vector3d> vector(std::string_view key, const YamlRange& range) const;
  /// Items of a list; empty if absent.
  const std::vector<YamlNode>& list(std::string_view key) const;

  const YamlNode& node() const { return node_; }
  const std::string& file() const { return file_; }
  SourcePos pos() const { return {file_, node_.line, node_.column}; }
  SourcePos pos(const YamlNode& node) const { return {file_, node.line, node.column}; }
  SourcePos keyPos(std::string_view key) const;

 private:
  const YamlNode& node_;
  const std::string& file_;
  std::string what_;
};

/// "a map", "a list", "nothing" or "`text`", for messages.
std::string yamlFound(const YamlNode& node);

/// Reads a single value; `label` names it in messages ("`scale`").
double yamlNumber(const YamlNode& node, const std::string& file, const std::string& label,
                  const YamlRange& range);
/// Text of 1 to kMaxYamlText characters.
inline constexpr std::size_t kMaxYamlText = 4096;
std::string yamlText(const YamlNode& node, const std::string& file, const std::string& label);
std::string yamlChoice(const YamlNode& node, const std::string& file, const std::string& label,
                       const std::vector<std::string>& choices);
const std::vector<YamlNode>& yamlList(const YamlNode& node, const std::string& file,
                                      const std::string& label);

/// "did you mean `x`?" for the nearest known name, or empty.
std::string nearestHint(const std::string& name, const std::vector<std::string>& known);

}  // namespace abstand::config
