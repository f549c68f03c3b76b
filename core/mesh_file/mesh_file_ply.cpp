// PLY, ASCII and binary in both byte orders.
#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "core/mesh_file/mesh_file_readers.hpp"
#include "core/text/text_lines.hpp"

namespace abstand::mesh_file {
namespace {

enum class Type { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat, kDouble };

struct Property {
  std::string name;
  Type type;
  std::optional<Type> count_type;  ///< for lists
};

struct ElementKind {
  std::string name;
  int count;
  std::vector<Property> properties;
};

enum class Encoding { kAscii, kLittle, kBig };

struct Header {
  Encoding encoding{Encoding::kAscii};
  std::vector<ElementKind> elements;
};

Type typeOf(std::string_view word, const SourcePos& pos) {
  constexpr std::array<std::array<std::string_view, 2>, 8> kNames{{{"char", "int8"},
                                                                   {"uchar", "uint8"},
                                                                   {"short", "int16"},
                                                                   {"ushort", "uint16"},
                                                                   {"int", "int32"},
                                                                   {"uint", "uint32"},
                                                                   {"float", "float32"},
                                                                   {"double", "float64"}}};
  for (std::size_t i = 0; i < kNames.size(); ++i)
    if (word == kNames[i][0] || word == kNames[i][1]) return static_cast<Type>(i);
  throw ParseError(pos,
                   "found " + text::inDoubleQuotes(word) + ", expected a PLY type such as float or uchar");
}

std::size_t sizeOf(Type type) {
  constexpr std::array<std::size_t, 8> kSizes{1, 1, 2, 2, 4, 4, 4, 8};
  return kSizes[static_cast<std::size_t>(type)];
}

Header readHeader(text::Lines& lines) {
  Header header;
  bool format_known = false;
  const auto magic = lines.next();
  if (!magic || !magic->starts_with("ply"))
    throw ParseError(lines.pos(), "found no \"ply\" in the first line, expected it");
  while (auto line = lines.next()) {
    auto rest = *line;
    const auto word = text::nextWord(rest);  // lines with other words are comments
    if (word == "end_header") {
      if (!format_known) throw ParseError(lines.pos(), "the header ends without a format line");
      return header;
    }
    if (word == "format") {
      const auto format = text::nextWord(rest);
      if (format == "ascii")
        header.encoding = Encoding::kAscii;
      else if (format == "binary_little_endian")
        header.encoding = Encoding::kLittle;
      else if (format == "binary_big_endian")
        header.encoding = Encoding::kBig;
      else
        throw ParseError(lines.pos(), "found format " + text::inDoubleQuotes(format) +
                                          ", expected ascii, binary_little_endian or binary_big_endian");
      format_known = true;
    } else if (word == "element") {
      const std::string name(text::nextWord(rest));
      const auto count_word = text::nextWord(rest);
      const auto count = parseInt(count_word);
      if (!count || *count < 0)
        throw ParseError(lines.pos(), "found " + text::inDoubleQuotes(count_word) +
                                          ", expected a number of elements below 2^31");
      header.elements.push_back({name, *count, {}});
    } else if (word == "property") {
      if (header.elements.empty()) throw ParseError(lines.pos(), "found a property before the first element");
      Property property{};
      auto type = text::nextWord(rest);
      if (type == "list") {
        property.count_type = typeOf(text::nextWord(rest), lines.pos());
        type = text::nextWord(rest);
      }
      property.type = typeOf(type, lines.pos());
      property.name = text::nextWord(rest);
      header.elements.back().properties.push_back(std::move(property));
    }
  }
  throw ParseError(lines.pos(), "the file ends within the header, expected end_header");
}

/// Sequential reader of the numbers after the header.
class Body {
 public:
  Body(const text::Lines& after_header, Encoding encoding)
      : lines_(after_header),
        data_(after_header.rest()),
        encoding_(encoding),
        pos_{after_header.pos().file, 0, 0} {}

  /// Called before each element. In ASCII an element is one line; columns beyond the declared properties are
  /// ignored.
  void beginElement() {
    if (encoding_ != Encoding::kAscii) return;
    do {
      const auto line = lines_.next();
      if (!line) end();
      data_ = *line;
    } while (data_.find_first_not_of(text::kBlank) == std::string_view::npos);
    pos_ = lines_.pos();
  }

  double next(Type type) {
    if (encoding_ == Encoding::kAscii) {
      return text::number(text::nextWord(data_), pos_);
    }
    std::array<char, 8> bytes{};
    const auto size = sizeOf(type);
    if (data_.size() < size) end();
    std::memcpy(bytes.data(), data_.data(), size);
    data_.remove_prefix(size);
    if ((encoding_ == Encoding::kBig) != (std::endian::native == std::endian::big))
      std::reverse(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
    switch (type) {
      case Type::kInt8:
        return as<std::int8_t>(bytes);
      case Type::kUint8:
        return as<std::uint8_t>(bytes);
      case Type::kInt16:
        return as<std::int16_t>(bytes);
      case Type::kUint16:
        return as<std::uint16_t>(bytes);
      case Type::kInt32:
        return as<std::int32_t>(bytes);
      case Type::kUint32:
        return as<std::uint32_t>(bytes);
      case Type::kFloat:
        return as<float>(bytes);
      case Type::kDouble:
        return as<double>(bytes);
    }
    return 0.0;
  }

  /// A list count or a vertex index: an integer from 0, below 2^32.
  std::uint32_t nextIndex(Type type) { return index(next(type)); }

  /// The same; nullopt for -1.
  std::optional<std::uint32_t> nextIndexOrEnd(Type type) {
    const double value = next(type);
    if (value == -1.0) return std::nullopt;
    return index(value);
  }

  const SourcePos& pos() const { return pos_; }

 private:
  std::uint32_t index(double value) const {
    if (!(value >= 0.0 && value < 4294967295.0) || value != std::floor(value))
      throw ParseError(
          pos_, "found " + formatDouble(value) + " in a list, expected a whole number that is not negative");
    return static_cast<std::uint32_t>(value);
  }

  template <class T>
  static double as(const std::array<char, 8>& bytes) {
    T value;
    std::memcpy(&value, bytes.data(), sizeof value);
    return static_cast<double>(value);
  }
  [[noreturn]] void end() const {
    throw ParseError(pos_, "the file ends before all elements that its header announces");
  }

  text::Lines lines_;
  std::string_view data_;  ///< remaining data; in ASCII, of the line
  Encoding encoding_;
  SourcePos pos_;
};

void skip(Body& body, const Property& property) {
  const std::uint32_t n = property.count_type ? body.nextIndex(*property.count_type) : 1;
  for (std::uint32_t i = 0; i < n; ++i) body.next(property.type);
}

/// Reads a list of an element `tristrips` (Stanford): strips in sequence, each ended by -1. Every three
/// consecutive corners are a triangle, every second one reversed.
void readStrips(Body& body, const Property& property, std::vector<std::uint32_t>& corners,
                std::vector<std::size_t>& ends) {
  const std::uint32_t n = body.nextIndex(*property.count_type);
  std::array<std::uint32_t, 3> last{};
  std::size_t length = 0;
  for (std::uint32_t k = 0; k < n; ++k) {
    const auto index = body.nextIndexOrEnd(property.type);
    if (!index) {
      length = 0;
      continue;
    }
    last = {last[1], last[2], *index};
    if (++length < 3) continue;
    const bool turned = length % 2 == 0;
    const std::array<std::uint32_t, 3> t{last[turned ? 1 : 0], last[turned ? 0 : 1], last[2]};
    // Degenerate triangles connect strips.
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
    corners.insert(corners.end(), t.begin(), t.end());
    ends.push_back(corners.size());
  }
}

void readVertices(Body& body, const ElementKind& kind, geometry::TriangleMesh& mesh) {
  constexpr std::array<std::string_view, 3> kAxes{"x", "y", "z"};
  for (const auto axis : kAxes) {
    const auto p = std::find_if(kind.properties.begin(), kind.properties.end(),
                                [&](const Property& q) { return q.name == axis && !q.count_type; });
    if (p == kind.properties.end())
      throw ParseError(body.pos(), "the vertices have no property " + std::string(axis));
  }
  for (int i = 0; i < kind.count; ++i) {
    body.beginElement();
    Vector3d v = Vector3d::Zero();
    for (const auto& property : kind.properties) {
      const auto axis = std::find(kAxes.begin(), kAxes.end(), property.name);
      if (axis != kAxes.end() && !property.count_type)
        v[axis - kAxes.begin()] = body.next(property.type);
      else
        skip(body, property);
    }
    if (!v.allFinite())
      throw ParseError(body.pos(), "found a coordinate that is not finite in vertex " + std::to_string(i) +
                                       " counted from 0");
    mesh.vertices.push_back(v);
  }
}

}  // namespace

geometry::TriangleMesh readPly(std::string_view content, const std::string& name) {
  text::Lines lines(content, name);
  const Header header = readHeader(lines);
  Body body(lines, header.encoding);
  geometry::TriangleMesh mesh;
  // Faces may precede vertices; they are triangulated after all are read.
  std::vector<std::uint32_t> corners;
  std::vector<std::size_t> ends;
  for (const auto& kind : header.elements) {
    if (kind.properties.empty()) continue;  // takes no space, whatever its count
    if (kind.name == "vertex") {
      readVertices(body, kind, mesh);
      continue;
    }
    for (int i = 0; i < kind.count; ++i) {
      body.beginElement();
      for (const auto& property : kind.properties) {
        const bool indices =
            property.count_type && (property.name == "vertex_indices" || property.name == "vertex_index");
        if (indices && kind.name == "tristrips") {
          readStrips(body, property, corners, ends);
          continue;
        }
        if (!indices || kind.name != "face") {
          skip(body, property);
          continue;
        }
        const auto n = body.nextIndex(*property.count_type);
        for (std::uint32_t k = 0; k < n; ++k) corners.push_back(body.nextIndex(property.type));
        ends.push_back(corners.size());
      }
    }
  }
  PolygonCutter cutter(mesh);
  std::size_t first = 0;
  for (const auto end : ends) {
    cutter.add(std::span(corners).subspan(first, end - first), {name});
    first = end;
  }
  return mesh;
}

}  // namespace abstand::mesh_file
