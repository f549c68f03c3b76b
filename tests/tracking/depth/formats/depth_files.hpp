// Depth files that tests write, byte by byte.
#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <vector>

#include "tracking/depth/camera/depth_camera.hpp"
#include "tracking/depth/camera/depth_image.hpp"

namespace abstand::testing {

/// A number of `size` bytes.
inline std::string bytesOf(std::uint64_t value, std::size_t size, bool is_low_first = true) {
  std::string bytes;
  for (std::size_t i = 0; i < size; ++i)
    bytes += static_cast<char>(value >> 8 * (is_low_first ? i : size - 1 - i) & 0xff);
  return bytes;
}

/// A NumPy array of version 1.
inline std::string npy(const std::string& type, const std::string& shape, const std::string& data) {
  std::string header = "{'descr': '" + type + "', 'fortran_order': False, 'shape': " + shape + ", }";
  header.resize((10 + header.size() + 64) / 64 * 64 - 11, ' ');
  header += '\n';
  return std::string("\x93NUMPY\1\0", 8) + bytesOf(header.size(), 2) + header + data;
}

/// A TIFF of one strip: width, height, bits, packing (1: none, 32773: PackBits), sample format.
struct TiffText {
  unsigned width{2}, height{2}, bits{16}, packing{1}, form{1};
  bool is_low_first{true};
  std::string strip;

  std::string bytes() const {
    const auto number = [&](unsigned n, std::size_t size) { return bytesOf(n, size, is_low_first); };
    std::string s = is_low_first ? "II" : "MM";
    s += number(42, 2) + number(8, 4);
    struct Entry {
      unsigned field, type, value;
    };
    const std::vector<Entry> entries{
        {256, 3, width},   {257, 3, height}, {258, 3, bits},
        {259, 3, packing}, {262, 3, 1},      {273, 4, 8 + 2 + 12 * 10 + 4},
        {277, 3, 1},       {278, 3, height}, {279, 4, static_cast<unsigned>(strip.size())},
        {339, 3, form}};
    s += number(static_cast<unsigned>(entries.size()), 2);
    for (const Entry& e : entries) {
      s += number(e.field, 2) + number(e.type, 2) + number(1, 4);
      s += e.type == 3 ? number(e.value, 2) + number(0, 2) : number(e.value, 4);
    }
    return s + number(0, 4) + strip;
  }
};

/// The points of a depth image as a PCD file; `kind` is ascii, binary or binary_compressed (packed in
/// literals).
inline std::string pcd(const tracking::DepthImage& image, const tracking::DepthCamera& camera,
                       const std::string& kind) {
  std::string head =
      "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z rgba\nSIZE 4 4 4 4\n"
      "TYPE F F F U\nCOUNT 1 1 1 1\nWIDTH " +
      std::to_string(image.width) + "\nHEIGHT " + std::to_string(image.height) +
      "\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + std::to_string(image.z.size()) + "\nDATA " + kind + "\n";
  std::vector<std::array<float, 3>> points;
  for (int v = 0; v < image.height; ++v)
    for (int u = 0; u < image.width; ++u) {
      const double z = static_cast<double>(image.at(u, v));
      const Vector3d p = z > 0.0 ? camera.at(u, v, z) : Vector3d(Vector3d::Constant(kNaN));
      points.push_back({static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())});
    }
  std::string data;
  const auto number = [&](float f) { return bytesOf(std::bit_cast<std::uint32_t>(f), 4); };
  if (kind == "ascii") {
    for (const auto& p : points) {
      char line[96];
      std::snprintf(line, sizeof line, "%.9g %.9g %.9g 4278190080\n", static_cast<double>(p[0]),
                    static_cast<double>(p[1]), static_cast<double>(p[2]));
      data += line;
    }
  } else if (kind == "binary") {
    for (const auto& p : points) data += number(p[0]) + number(p[1]) + number(p[2]) + bytesOf(0xff000000u, 4);
  } else {
    std::string whole;
    for (std::size_t k = 0; k < 3; ++k)
      for (const auto& p : points) whole += number(p[k]);
    for (std::size_t i = 0; i < points.size(); ++i) whole += bytesOf(0xff000000u, 4);
    std::string packed;
    for (std::size_t i = 0; i < whole.size(); i += 32) {
      const std::string run = whole.substr(i, 32);
      packed += static_cast<char>(run.size() - 1) + run;
    }
    data = bytesOf(packed.size(), 4) + bytesOf(whole.size(), 4) + packed;
  }
  return head + data;
}

}  // namespace abstand::testing
