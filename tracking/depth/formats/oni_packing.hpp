// Decompression of OpenNI depth images.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace abstand::tracking {

/// Compression schemes of OpenNI's recorders for depth.
enum class OniPacking : std::uint8_t {
  kNone,   ///< `NONE`: 16 bits for each pixel, the low byte first
  k16z,    ///< `16zP`: the first number, then differences
  kTable,  ///< `16zT`: as 16zP, for indices into a table of the image's values, which comes first
};

/// Returns the `count` numbers of an image. Source of the format: OpenNI2, Source/Drivers/OniFile/Formats
/// (Apache 2). After the first number, a byte has two differences (last - next + 6, 0 to 12) of four bits
/// each, the higher first; 13 in the lower half: no number. 15 in the lower half, or the byte 0xff alone: an
/// explicit number follows: a byte from 0x80 is last - next + 192, otherwise two bytes are the number, the
/// high one first. 0xe0 + n repeats the last number 2 n times. Throws ParseError with `file`.
std::vector<std::uint16_t> unpackOni(std::string_view bytes, OniPacking packing, std::size_t count,
                                     const std::string& file);

}  // namespace abstand::tracking
