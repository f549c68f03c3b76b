// What the first bytes of a PNG say, before a decoder reserves memory for what a stranger says.
#pragma once

#include <string>

namespace abstand::tracking {

struct PngHeader {
  int width{0}, height{0};  ///< pixels
  unsigned bits{0};         ///< a channel
  unsigned colour{0};       ///< 0 grey, 2 RGB, 3 palette, 4 grey with alpha, 6 RGB with alpha
};

/// Throws ParseError for what is no PNG, and for sides above DepthCamera::kMaxPixels. `expected` ends the
/// sentence, like "a depth image".
PngHeader readPngHeader(const std::string& bytes, const std::string& file, const std::string& expected);

}  // namespace abstand::tracking
