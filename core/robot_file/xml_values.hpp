// Typed values of XML attributes; every error has its position.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.hpp"
#include "core/math/transform.hpp"
#include "core/text/xml_element.hpp"

namespace abstand::robot_file {

using text::XmlElement;

/// Values of elements of one file. `file` must outlive this object.
class XmlValues {
 public:
  explicit XmlValues(const std::string& file) : file_(file) {}

  SourcePos pos(const XmlElement& e) const { return {file_, e.line, e.column}; }
  [[noreturn]] void fail(const XmlElement& e, const std::string& message, const std::string& hint = {}) const;
  /// `FILE:LINE:COLUMN: TEXT`.
  std::string warning(const XmlElement& e, const std::string& text) const;

  /// The attribute with &lt; &gt; &amp; &quot; &apos; decoded; nullopt if absent. Throws ParseError for other
  /// entities, control characters and invalid UTF-8.
  std::optional<std::string> text(const XmlElement& e, std::string_view key) const;
  /// Throws ParseError if the attribute is missing or empty.
  std::string needText(const XmlElement& e, std::string_view key) const;
  /// A finite number, at most kLargest in absolute value; nullopt if absent.
  std::optional<double> number(const XmlElement& e, std::string_view key) const;
  double needNumber(const XmlElement& e, std::string_view key) const;
  /// Three numbers; nullopt if absent.
  std::optional<Vector3d> vector(const XmlElement& e, std::string_view key) const;

  /// Larger values are errors; sums and products of smaller ones stay finite.
  static constexpr double kLargest = 1e6;

 private:
  double parse(const XmlElement& e, std::string_view key, std::string_view word) const;

  const std::string& file_;
};

/// Escapes text for an attribute in double quotes.
std::string xmlEscaped(const std::string& text);
/// "x y z" with enough digits to read back exactly.
std::string xmlNumbers(std::span<const double> values);
std::string xmlNumbers(const Vector3d& v);

}  // namespace abstand::robot_file
