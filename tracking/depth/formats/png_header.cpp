// Reads a PNG header, before a decoder allocates memory for untrusted sizes.
#include "tracking/depth/formats/png_header.hpp"

#include <cstdint>

#include "core/base/error.hpp"
#include "tracking/depth/camera/depth_camera.hpp"

namespace abstand::tracking {
namespace {

// Signature, length and name of the first chunk, width, height, bits, colour type.
constexpr std::size_t kHeader = 26;

std::uint32_t bigEndian(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
  return value;
}

}  // namespace

PngHeader readPngHeader(const std::string& bytes, const std::string& file, const std::string& expected) {
  const SourcePos place{file};
  if (bytes.size() < kHeader || bytes.compare(0, 8, "\x89PNG\r\n\x1a\n") != 0 ||
      bytes.compare(12, 4, "IHDR") != 0)
    throw ParseError(place, "found no PNG, expected " + expected);
  const std::uint32_t width = bigEndian(bytes, 16), height = bigEndian(bytes, 20);
  if (width == 0 || height == 0 || width > DepthCamera::kMaxPixels || height > DepthCamera::kMaxPixels)
    throw ParseError(place, "found " + std::to_string(width) + " x " + std::to_string(height) +
                                " pixels, expected 1 to " + std::to_string(DepthCamera::kMaxPixels) +
                                " along a side");
  return {static_cast<int>(width), static_cast<int>(height), static_cast<unsigned char>(bytes[24]),
          static_cast<unsigned char>(bytes[25])};
}

}  // namespace abstand::tracking
