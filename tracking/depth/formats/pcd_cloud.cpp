// Organised point clouds of PCL, as images of a depth camera.
#include "tracking/depth/formats/pcd_cloud.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "core/base/error.hpp"
#include "core/base/number.hpp"
#include "core/text/message_text.hpp"
#include "tracking/depth/formats/lzf.hpp"
#include "tracking/table/cells.hpp"

namespace abstand::tracking {
namespace {

constexpr std::size_t kMaxPcdFields = 64;
constexpr std::size_t kMaxPointBytes = 1024;
constexpr std::size_t kMaxPcdBytes = std::size_t{1} << 30;

struct Field {
  std::string name;
  std::size_t size{4}, count{1};
  char type{'F'};
  std::size_t offset{0};  ///< within a point, bytes
};

struct Header {
  std::vector<Field> fields;
  std::size_t width{0}, height{1};
  std::string kind;
  std::size_t data{0};  ///< offset of the data
  int line{0};
};

std::vector<std::string_view> words(std::string_view line) {
  std::vector<std::string_view> found;
  for (std::size_t i = 0; i < line.size();) {
    while (i < line.size() && (line[i] == ' ' || line[i] == '\t')) ++i;
    const std::size_t from = i;
    while (i < line.size() && line[i] != ' ' && line[i] != '\t') ++i;
    if (i > from) found.push_back(line.substr(from, i - from));
  }
  return found;
}

Header parseHeader(std::string_view bytes, const std::string& file) {
  Header header;
  Lines lines(bytes);
  std::string_view line;
  const auto fail = [&](const std::string& message) { throw ParseError({file, lines.number()}, message); };
  const auto number = [&](std::string_view text, int min, int max) {
    const auto n = parseInt(text);
    if (!n || *n < min || *n > max)
      fail("found " + text::inQuotes(text) + ", expected a number from " + std::to_string(min) + " to " +
           std::to_string(max));
    return static_cast<std::size_t>(n.value_or(min));
  };
  std::size_t points = 0;
  bool has_points = false;
  while (lines.next(line)) {
    const std::vector<std::string_view> w = words(line.substr(0, line.find('#')));
    if (w.empty()) continue;
    const std::size_t values = w.size() - 1;
    if (w[0] == "FIELDS" || w[0] == "COLUMNS") {
      if (values == 0 || values > kMaxPcdFields || !header.fields.empty())
        fail("found " + std::to_string(values) + " fields, expected 1 to 64, once");
      for (std::size_t i = 0; i < values; ++i) header.fields.push_back({std::string(w[i + 1])});
    } else if (w[0] == "SIZE" || w[0] == "TYPE" || w[0] == "COUNT") {
      if (values != header.fields.size())
        fail("found " + std::to_string(values) + " values after " + std::string(w[0]) +
             ", expected one a field, " + std::to_string(header.fields.size()));
      for (std::size_t i = 0; i < values; ++i) {
        Field& field = header.fields[i];
        if (w[0] == "SIZE")
          field.size = number(w[i + 1], 1, 8);
        else if (w[0] == "COUNT")
          field.count = number(w[i + 1], 1, 256);
        else
          field.type = w[i + 1][0];
      }
    } else if (w[0] == "WIDTH" && values == 1) {
      header.width = number(w[1], 1, 1 << 24);
    } else if (w[0] == "HEIGHT" && values == 1) {
      header.height = number(w[1], 1, 1 << 24);
    } else if (w[0] == "POINTS" && values == 1) {
      points = number(w[1], 1, 1 << 30);
      has_points = true;
    } else if (w[0] == "DATA" && values == 1) {
      header.kind = w[1];
      break;
    } else if (w[0] != "VERSION" && w[0] != "VIEWPOINT") {
      fail("found " + text::inQuotes(w[0]) + ", expected a line of a PCD header");
    }
  }
  header.line = lines.number();
  if (header.kind != "ascii" && header.kind != "binary" && header.kind != "binary_compressed")
    fail("found DATA " + text::inQuotes(header.kind) + ", expected ascii, binary or binary_compressed");
  if (header.width < 2 || header.height < 2)
    fail("found a cloud of " + std::to_string(header.width) + " x " + std::to_string(header.height) +
         " points, expected an organised one, a point for each pixel");
  if (header.width > DepthCamera::kMaxPixels || header.height > DepthCamera::kMaxPixels)
    fail("found " + std::to_string(header.width) + " x " + std::to_string(header.height) +
         " points, expected at most " + std::to_string(DepthCamera::kMaxPixels) + " along a side");
  if (has_points && points != header.width * header.height)
    fail("found POINTS " + std::to_string(points) + ", expected width times height, " +
         std::to_string(header.width * header.height));
  std::size_t offset = 0;
  for (Field& field : header.fields) {
    field.offset = offset;
    offset += field.size * field.count;
  }
  if (offset > kMaxPointBytes)
    fail("found points of " + std::to_string(offset) + " bytes, expected at most 1024");
  // End of the DATA line.
  header.data = static_cast<std::size_t>(line.data() + line.size() - bytes.data());
  if (header.data < bytes.size() && bytes[header.data] == '\r') ++header.data;
  if (header.data < bytes.size() && bytes[header.data] == '\n') ++header.data;
  return header;
}

std::size_t coordinate(const Header& header, const char* name, const std::string& file) {
  for (std::size_t i = 0; i < header.fields.size(); ++i) {
    const Field& f = header.fields[i];
    if (f.name != name) continue;
    if (f.type != 'F' || (f.size != 4 && f.size != 8) || f.count != 1)
      throw ParseError({file}, std::string("found ") + name + " of type " + f.type + std::to_string(f.size) +
                                   ", expected F4 or F8");
    return i;
  }
  throw ParseError({file}, std::string("found no field ") + name + ", expected x, y and z");
}

float readFloat(std::string_view data, std::size_t at, std::size_t size) {
  if (size == 4) {
    float value;
    std::memcpy(&value, data.data() + at, sizeof value);
    return value;
  }
  double value;
  std::memcpy(&value, data.data() + at, sizeof value);
  return static_cast<float>(value);
}

/// Parses numbers; "nan" without measurement.
void parseAscii(std::string_view data, const Header& header, const std::array<std::size_t, 3>& xyz,
                const std::string& file, PcdCloud& cloud) {
  std::array<std::size_t, 3> column{};
  std::size_t columns = 0;
  for (std::size_t i = 0; i < header.fields.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k)
      if (xyz[k] == i) column[k] = columns;
    columns += header.fields[i].count;
  }
  Lines lines(data);
  std::string_view line;
  while (lines.next(line)) {
    const std::vector<std::string_view> w = words(line);
    if (w.empty()) continue;
    const SourcePos pos{file, header.line + lines.number()};
    if (w.size() != columns)
      throw ParseError(pos,
                       "found " + std::to_string(w.size()) + " numbers, expected " + std::to_string(columns));
    if (cloud.points.size() == header.width * header.height)
      throw ParseError(pos, "found more points, expected " + std::to_string(cloud.points.size()));
    Vector3f p;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::string_view text = w[column[k]];
      const auto value = parseDouble(text);
      if (!value && text::lowerCase(text) != "nan" && text::lowerCase(text) != "-nan")
        throw ParseError(pos, "found " + text::inQuotes(text) + ", expected a number or nan");
      p[static_cast<Eigen::Index>(k)] = static_cast<float>(value.value_or(kNaN));
    }
    cloud.points.push_back(p);
  }
}

}  // namespace

PcdCloud parsePcd(std::string_view bytes, const std::string& file) {
  const Header header = parseHeader(bytes, file);
  const std::array<std::size_t, 3> xyz{coordinate(header, "x", file), coordinate(header, "y", file),
                                       coordinate(header, "z", file)};
  const Field& last = header.fields.back();
  const std::size_t stride = last.offset + last.size * last.count, count = header.width * header.height;
  std::string_view data = bytes.substr(header.data);
  PcdCloud cloud{static_cast<int>(header.width), static_cast<int>(header.height), {}};
  const auto fail = [&](const std::string& message) { throw ParseError({file}, message); };
  std::string unpacked;
  if (header.kind == "ascii") {
    parseAscii(data, header, xyz, file, cloud);
    if (cloud.points.size() != count)
      fail("found " + std::to_string(cloud.points.size()) + " points, expected " + std::to_string(count));
    return cloud;
  }
  if (stride * count > kMaxPcdBytes)
    fail("found " + std::to_string(stride * count) + " bytes of points, expected at most 1073741824");
  const bool is_packed = header.kind == "binary_compressed";
  if (is_packed) {
    // Compressed and uncompressed size, then all x, all y and so on.
    if (data.size() < 8) fail("found the end of the file, expected packed points");
    std::uint32_t packed = 0, whole = 0;
    std::memcpy(&packed, data.data(), 4);
    std::memcpy(&whole, data.data() + 4, 4);
    if (packed > data.size() - 8)
      fail("found " + std::to_string(data.size() - 8) + " bytes of packed points, expected " +
           std::to_string(packed));
    if (whole != stride * count)
      fail("found " + std::to_string(whole) + " bytes of points, expected " + std::to_string(stride * count));
    if (!unpackLzf(data.substr(8, packed), whole, unpacked) || unpacked.size() != whole)
      fail("found packed points that are damaged, expected LZF");
    data = unpacked;
  } else if (data.size() < stride * count) {
    fail("found " + std::to_string(data.size()) + " bytes of points, expected " +
         std::to_string(stride * count));
  }
  cloud.points.resize(count);
  for (std::size_t k = 0; k < 3; ++k) {
    const Field& f = header.fields[xyz[k]];
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t at = is_packed ? f.offset * count + i * f.size : i * stride + f.offset;
      cloud.points[i][static_cast<Eigen::Index>(k)] = readFloat(data, at, f.size);
    }
  }
  return cloud;
}

FittedCamera fitCamera(const PcdCloud& cloud, const std::string& file) {
  constexpr std::size_t kFewest = 100;
  constexpr double kMaxResidual = 0.5;  // pixels
  // Rows u = fx x / z + cx, and the same for v.
  struct Sums {
    double n{0}, a{0}, aa{0}, p{0}, ap{0};
  } across, down;
  const auto each = [&](const auto& visit) {
    for (int v = 0; v < cloud.height; ++v)
      for (int u = 0; u < cloud.width; ++u) {
        const Vector3f& p = cloud.points[static_cast<std::size_t>(v) * static_cast<std::size_t>(cloud.width) +
                                         static_cast<std::size_t>(u)];
        if (!p.allFinite() || !(p.z() > 0.05f && p.z() < 100.0f)) continue;
        const Vector3d q = p.cast<double>();
        visit(u, v, q.x() / q.z(), q.y() / q.z());
      }
  };
  const auto add = [](Sums& s, double a, double pixel) {
    s.n += 1, s.a += a, s.aa += a * a, s.p += pixel, s.ap += a * pixel;
  };
  each([&](int u, int v, double a, double b) {
    add(across, a, u);
    add(down, b, v);
  });
  if (across.n < static_cast<double>(kFewest))
    throw ParseError({file}, "found " + std::to_string(static_cast<std::size_t>(across.n)) +
                                 " points, expected at least 100");
  const auto solve = [](const Sums& s, double& focal, double& centre) {
    const double det = s.n * s.aa - s.a * s.a;
    focal = (s.n * s.ap - s.a * s.p) / det;
    centre = (s.aa * s.p - s.a * s.ap) / det;
  };
  FittedCamera fit;
  fit.camera.width = cloud.width;
  fit.camera.height = cloud.height;
  solve(across, fit.camera.fx, fit.camera.cx);
  solve(down, fit.camera.fy, fit.camera.cy);
  std::vector<double> off;
  each([&](int u, int v, double a, double b) {
    off.push_back(std::hypot(fit.camera.fx * a + fit.camera.cx - u, fit.camera.fy * b + fit.camera.cy - v));
  });
  const auto middle = off.begin() + static_cast<std::ptrdiff_t>(off.size() / 2);
  std::nth_element(off.begin(), middle, off.end());
  fit.residual = *middle;
  // The negated form also rejects NaN.
  if (!(fit.residual <= kMaxResidual && fit.camera.fx > 0.0 && fit.camera.fy > 0.0))
    throw ParseError({file}, "found points that do not fit a pinhole camera (" +
                                 text::rounded(fit.residual, 1) +
                                 " pixels error), expected those of a depth camera");
  return fit;
}

}  // namespace abstand::tracking
