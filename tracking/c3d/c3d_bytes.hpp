// Numbers in the bytes of a C3D file, in its three byte orders.
#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/error.hpp"

namespace abstand::tracking {

/// Processor types of C3D files, with the numbers in the file. DEC has Intel integers and its own float
/// format.
enum class C3dProcessor : std::uint8_t { kIntel = 84, kDec = 85, kMips = 86 };

/// View of a file, read by offset. Reading beyond its end is a ParseError with the offset.
class C3dBytes {
 public:
  C3dBytes(std::string_view bytes, std::string file) : bytes_(bytes), file_(std::move(file)) {}

  C3dProcessor processor{C3dProcessor::kIntel};

  std::size_t size() const { return bytes_.size(); }
  std::string_view text(std::size_t at, std::size_t count) const {
    if (at > bytes_.size() || count > bytes_.size() - at)
      fail(at, "found the end of the file, expected " + std::to_string(count) + " bytes");
    return bytes_.substr(at, count);
  }
  std::uint8_t u8(std::size_t at) const { return static_cast<std::uint8_t>(text(at, 1)[0]); }
  std::int8_t i8(std::size_t at) const { return static_cast<std::int8_t>(u8(at)); }
  std::uint16_t u16(std::size_t at) const {
    const auto b = text(at, 2);
    const unsigned a = static_cast<std::uint8_t>(b[0]), c = static_cast<std::uint8_t>(b[1]);
    return static_cast<std::uint16_t>(processor == C3dProcessor::kMips ? a << 8 | c : c << 8 | a);
  }
  std::int16_t i16(std::size_t at) const { return static_cast<std::int16_t>(u16(at)); }
  /// IEEE 754, or DEC F_floating: words swapped, exponent bias larger by 2. May be NaN.
  float f32(std::size_t at) const {
    const std::uint32_t first = u16(at), second = u16(at + 2);
    if (processor == C3dProcessor::kIntel) return std::bit_cast<float>(second << 16 | first);
    const float value = std::bit_cast<float>(first << 16 | second);
    return processor == C3dProcessor::kDec ? 0.25f * value : value;
  }

  [[noreturn]] void fail(std::size_t at, const std::string& message) const {
    throw ParseError({file_}, "at byte " + std::to_string(at) + ": " + message);
  }

 private:
  std::string_view bytes_;
  std::string file_;
};

}  // namespace abstand::tracking
