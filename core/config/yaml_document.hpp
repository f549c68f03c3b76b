// A YAML text as a tree of plain nodes, each with its place in the file.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/error.hpp"

namespace abstand::config {

/// One node. Lines and columns count from 1.
struct YamlNode {
  enum class Kind : std::uint8_t { kNothing, kScalar, kList, kMap };
  struct Key {
    std::string text;
    int line{0}, column{0};
  };

  Kind kind{Kind::kNothing};
  bool quoted{false};  ///< a scalar in quotes: text, never a number
  int line{0}, column{0};
  std::string text;             ///< of a scalar
  std::vector<Key> keys;        ///< of a map, in file order; each is there once
  std::vector<YamlNode> items;  ///< of a list; of a map: the values, in the order of `keys`
};

/// Reads one YAML document of a stranger. Aliases are written out. Throws ParseError for broken YAML, more
/// than one document, control characters, tags, keys that are no scalars or are there twice, and for what is
/// no sane scene: more than kMaxYamlBytes of text, kMaxYamlDepth levels or kMaxYamlNodes nodes (aliases
/// written out).
inline constexpr std::size_t kMaxYamlBytes = 4u << 20;
inline constexpr int kMaxYamlDepth = 32;
inline constexpr int kMaxYamlNodes = 200000;
YamlNode parseYaml(const std::string& text, const std::string& file);

}  // namespace abstand::config
