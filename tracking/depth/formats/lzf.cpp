// LZF decompression, for PCD files.
#include "tracking/depth/formats/lzf.hpp"

#include <algorithm>

namespace abstand::tracking {

bool unpackLzf(std::string_view packed, std::size_t max_size, std::string& out) {
  // A byte of input expands to at most 88 bytes (three bytes to 264).
  out.clear();
  out.reserve(std::min(max_size, 88 * packed.size()));
  std::size_t at = 0;
  while (at < packed.size()) {
    const auto control = static_cast<unsigned char>(packed[at++]);
    if (control < 32) {
      const std::size_t count = control + std::size_t{1};
      if (packed.size() - at < count || max_size - out.size() < count) return false;
      out.append(packed, at, count);
      at += count;
      continue;
    }
    std::size_t count = control >> 5;
    const bool is_long = count == 7;
    if (packed.size() - at < (is_long ? 2u : 1u)) return false;
    if (is_long) count += static_cast<unsigned char>(packed[at++]);
    const std::size_t distance =
        (static_cast<std::size_t>(control & 31) << 8 | static_cast<unsigned char>(packed[at++])) + 1;
    count += 2;
    if (distance > out.size() || max_size - out.size() < count) return false;
    // Source and destination may overlap.
    for (std::size_t i = 0; i < count; ++i) out.push_back(out[out.size() - distance]);
  }
  return true;
}

}  // namespace abstand::tracking
