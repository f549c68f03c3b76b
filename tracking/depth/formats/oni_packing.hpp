// How OpenNI packs the depths of an image.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace abstand::tracking {

/// The three that OpenNI's recorders use for depth.
enum class OniPacking : std::uint8_t {
  kNone,   ///< `NONE`: 16 bits a pixel, the low byte first
  k16z,    ///< `16zP`: the first number, then differences
  kTable,  ///< `16zT`: the same of places in a table of the numbers that the image has, which comes first
};

/// The `count` numbers of an image. Source of the format: OpenNI2, Source/Drivers/OniFile/Formats (Apache 2).
/// After the first number, a byte holds two differences (last - next + 6, 0 to 12) of four bits each, the
/// higher first; 13 in the lower is no number. 15 in the lower, or the byte 0xff alone, says that one follows
/// in full: a byte from 0x80 is last - next + 192, else two bytes are the number, the high one first. 0xe0 +
/// n is 2 n numbers like the last. Throws ParseError that names `file`.
std::vector<std::uint16_t> unpackOni(std::string_view bytes, OniPacking packing, std::size_t count,
                                     const std::string& file);

}  // namespace abstand::tracking
