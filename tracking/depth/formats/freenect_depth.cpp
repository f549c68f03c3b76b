// Depth frames written by libfreenect's `record`.
#include "tracking/depth/formats/freenect_depth.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"
#include "core/base/number.hpp"
#include "core/text/message_text.hpp"
#include "tracking/depth/camera/depth_camera.hpp"

namespace abstand::tracking {
namespace {

constexpr int kNoDisparity = 2047;
constexpr int kMaxFreenectMillimetres = 10000;  // FREENECT_DEPTH_MM_MAX_VALUE
constexpr double kMaxFreenectDepth = 10.0;      // m
// 1 / m, and 1 / m for each step: the line of freenectDepth().
constexpr double kLineAtZero = 3.3309495161, kLineStep = 0.0030711016;

struct FreenectHeader {
  int width{0}, height{0};
  std::size_t data{0};  ///< offset of the pixels
};

/// `P5 WIDTH HEIGHT MAXIMUM` and one blank; comment lines begin with #.
FreenectHeader parseFreenectHeader(std::string_view bytes, const std::string& file) {
  std::size_t at = 0;
  const auto fail = [&](const std::string& message) -> void {
    throw ParseError({file}, "at byte " + std::to_string(at) + ": " + message);
  };
  const auto isBlank = [](char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; };
  const auto word = [&] {
    while (at < bytes.size() && (isBlank(bytes[at]) || bytes[at] == '#')) {
      if (bytes[at] == '#')
        while (at < bytes.size() && bytes[at] != '\n') ++at;
      else
        ++at;
    }
    const std::size_t from = at;
    while (at < bytes.size() && !isBlank(bytes[at]) && at - from < 20) ++at;
    return bytes.substr(from, at - from);
  };
  if (word() != "P5") {
    at = 0;
    fail("found no PGM, expected P5, a depth frame of libfreenect's record");
  }
  const auto number = [&](const char* what, int max) {
    const std::string_view text = word();
    const auto n = parseInt(text);
    if (!n || *n < 1 || *n > max)
      fail("found " + text::inQuotes(text) + ", expected " + what + " from 1 to " + std::to_string(max));
    return n.value_or(0);
  };
  FreenectHeader header;
  header.width = number("a width", DepthCamera::kMaxPixels);
  header.height = number("a height", DepthCamera::kMaxPixels);
  const int maximum = number("a largest value", 65535);
  if (maximum < 256) fail("found one byte a pixel, expected two");
  if (at >= bytes.size() || !isBlank(bytes[at])) fail("found no blank after the header, expected one");
  header.data = at + 1;
  const std::size_t size =
      2 * static_cast<std::size_t>(header.width) * static_cast<std::size_t>(header.height);
  if (bytes.size() - header.data < size)
    fail("found " + std::to_string(bytes.size() - header.data) + " bytes of pixels, expected " +
         std::to_string(size));
  return header;
}

int pixel(std::string_view pixels, std::size_t i, bool is_low_first) {
  const int a = static_cast<unsigned char>(pixels[2 * i]), b = static_cast<unsigned char>(pixels[2 * i + 1]);
  return is_low_first ? a | b << 8 : b | a << 8;
}

FreenectUnits unitsOf(std::string_view pixels, std::size_t count, const std::string& file) {
  for (const int limit : {kNoDisparity, kMaxFreenectMillimetres}) {
    for (const bool is_low_first : {true, false}) {
      int largest = 0;
      std::size_t none = 0, zero = 0;
      for (std::size_t i = 0; i < count && largest <= limit; ++i) {
        const int value = pixel(pixels, i, is_low_first);
        largest = std::max(largest, value);
        none += value == kNoDisparity;
        zero += value == 0;
      }
      if (largest > limit) continue;
      FreenectUnits units;
      units.is_low_first = is_low_first;
      units.is_raw = limit == kNoDisparity && none >= zero;
      units.reason = units.is_raw
                         ? "numbers up to 2047, which marks missing pixels: 11-bit disparities"
                         : "numbers up to " + std::to_string(largest) + ", 0 for missing: millimetres";
      units.reason += is_low_first ? "; little-endian, as written by record" : "; big-endian, as in PGM";
      return units;
    }
  }
  throw ParseError({file}, "found pixels above 10000, expected disparities of 11 bits or millimetres");
}

}  // namespace

float freenectDepth(int raw) {
  if (raw < 0 || raw >= kNoDisparity) return 0.0f;
  const double inverse = kLineAtZero - kLineStep * raw;
  return inverse > 1.0 / kMaxFreenectDepth ? static_cast<float>(1.0 / inverse) : 0.0f;
}

int freenectRaw(float z) {
  // The negated form also handles NaN.
  if (!(z > 0.0f)) return kNoDisparity;
  const double raw = std::round((kLineAtZero - 1.0 / static_cast<double>(z)) / kLineStep);
  if (!(raw >= 0.0 && raw < kNoDisparity)) return kNoDisparity;
  return freenectDepth(static_cast<int>(raw)) > 0.0f ? static_cast<int>(raw) : kNoDisparity;
}

std::string freenectDump(const DepthImage& image) {
  std::string bytes = "P5 " + std::to_string(image.width) + " " + std::to_string(image.height) + " 65535\n";
  bytes.reserve(bytes.size() + 2 * image.z.size());
  for (const float z : image.z) {
    const int raw = freenectRaw(z);
    bytes += static_cast<char>(raw & 0xff);
    bytes += static_cast<char>(raw >> 8);
  }
  return bytes;
}

FreenectImage parseFreenectDepth(std::string_view bytes, const std::string& file,
                                 const std::optional<FreenectUnits>& units) {
  const FreenectHeader header = parseFreenectHeader(bytes, file);
  FreenectImage read{DepthImage(header.width, header.height), {}};
  const std::string_view pixels = bytes.substr(header.data);
  read.units = units ? *units : unitsOf(pixels, read.image.z.size(), file);
  for (std::size_t i = 0; i < read.image.z.size(); ++i) {
    const int value = pixel(pixels, i, read.units.is_low_first);
    read.image.z[i] = read.units.is_raw ? freenectDepth(value) : static_cast<float>(value) * 0.001f;
  }
  return read;
}

}  // namespace abstand::tracking
