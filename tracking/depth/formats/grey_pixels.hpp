// Pixels of a grey picture, as decoders give them.
#pragma once

#include <cstdint>
#include <vector>

namespace abstand::tracking {

/// Row by row from the top. `bits` is 8 or 16: the range of the values.
struct GreyPixels {
  int width{0}, height{0}, bits{0};
  std::vector<std::uint16_t> values;
};

}  // namespace abstand::tracking
