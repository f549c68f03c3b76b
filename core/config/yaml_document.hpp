// A YAML text as a tree of plain nodes, each with its position in the file.
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
  bool quoted{false};  ///< a quoted scalar: text, never a number
  int line{0}, column{0};
  std::string text;             ///< of a scalar
  std::vector<Key> keys;        ///< of a map, in file order, without duplicates
  std::vector<YamlNode> items;  ///< of a list; of a map: the values, in the order of `keys`
};

/// Parses one untrusted YAML document; aliases are expanded. Throws ParseError for invalid YAML, more than
/// one document, control characters, tags, duplicate keys or keys that are not scalars, and beyond the
/// limits: kMaxYamlBytes of text, kMaxYamlDepth levels, kMaxYamlNodes nodes (after expansion).
inline constexpr std::size_t kMaxYamlBytes = 4u << 20;
inline constexpr int kMaxYamlDepth = 32;
inline constexpr int kMaxYamlNodes = 200000;
YamlNode parseYaml(const std::string& text, const std::string& file);

}  // namespace abstand::config
