// XML parser for the subset that COLLADA, URDF and SRDF files use; internal to their readers.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace abstand::text {

/// An element. Names and attributes point into the document; entities in them are not decoded.
struct XmlElement {
  std::string_view name;
  std::vector<std::pair<std::string_view, std::string_view>> attributes;
  std::vector<XmlElement> children;
  std::string text;        ///< text of the element itself, without that of its children
  int line{0}, column{0};  ///< position of its '<', counted from 1; the column in bytes

  /// Value of the attribute; empty if there is none.
  std::string_view attribute(std::string_view key) const;
  /// The first child of that name, or null.
  const XmlElement* child(std::string_view key) const;
};

/// Returns the root element. Throws ParseError if the document is not well-formed, not UTF-8 or ASCII, or
/// nested deeper than 256. `name` is the file's name. Entities declared in a DTD are not expanded.
XmlElement parseXml(std::string_view document, const std::string& name);

}  // namespace abstand::text
