// Reads a PNG header, before a decoder allocates memory for untrusted sizes.
#pragma once

#include <string>

namespace abstand::tracking {

struct PngHeader {
  int width{0}, height{0};  ///< pixels
  unsigned bits{0};         ///< per channel
  unsigned colour{0};       ///< 0 grey, 2 RGB, 3 palette, 4 grey with alpha, 6 RGB with alpha
};

/// Throws ParseError if it is not a PNG, and for sides above DepthCamera::kMaxPixels. `expected` ends the
/// sentence of the error, e.g. "a depth image".
PngHeader readPngHeader(const std::string& bytes, const std::string& file, const std::string& expected);

}  // namespace abstand::tracking
