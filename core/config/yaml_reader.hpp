// Typed values out of a YAML tree; every error names its place.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/config/yaml_document.hpp"
#include "core/math/transform.hpp"

namespace abstand::config {

/// Allowed numbers: least <= x <= most, or least < x with `above`.
struct YamlRange {
  double least, most;
  const char* unit{""};
  bool above{false};
};

/// One map of a scene file whose keys are all known. `what` names it in messages ("an object"). Getters of an
/// absent key give nullopt or null; a value of another type or out of range is a ParseError at its place.
class YamlFields {
 public:
  /// Throws ParseError when the node is no map or has a key that is not among `known`.
  YamlFields(const YamlNode& node, const std::string& file, std::string what, std::vector<std::string> known);

  const YamlNode* find(std::string_view key) const;
  /// Throws ParseError at the map when the key is not there.
  const YamlNode& need(std::string_view key) const;

  std::optional<double> number(std::string_view key, const YamlRange& range) const;
  std::optional<int> integer(std::string_view key, int least, int most) const;
  std::optional<std::string> text(std::string_view key) const;
  /// One of `choices`.
  std::optional<std::string> choice(std::string_view key, const std::vector<std::string>& choices) const;
  std::optional<Vector3d> vector(std::string_view key, const YamlRange& range) const;
  /// The nodes of a list; empty when absent.
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

/// Single values; `label` names what they stand for ("`scale`").
double yamlNumber(const YamlNode& node, const std::string& file, const std::string& label,
                  const YamlRange& range);
/// Not empty, at most kMaxYamlText characters.
inline constexpr std::size_t kMaxYamlText = 4096;
std::string yamlText(const YamlNode& node, const std::string& file, const std::string& label);
std::string yamlChoice(const YamlNode& node, const std::string& file, const std::string& label,
                       const std::vector<std::string>& choices);
const std::vector<YamlNode>& yamlList(const YamlNode& node, const std::string& file,
                                      const std::string& label);

/// "did you mean `x`?" for the nearest known name, or empty.
std::string nearestHint(const std::string& name, const std::vector<std::string>& known);

}  // namespace abstand::config
