// Depth images as 16-bit TIFF.
#include "tracking/depth/formats/depth_tiff.hpp"

#include <cstdint>

#include "core/base/error.hpp"
#include "tracking/depth/camera/depth_camera.hpp"
#include "tracking/depth/formats/depth_of_grey.hpp"
#include "tracking/depth/formats/tiff_codec.hpp"

namespace abstand::tracking {
namespace {

enum : unsigned {
  kWidth = 256,
  kHeight = 257,
  kBits = 258,
  kOrientation = 274,
  kChannels = 277,
  kSampleFormat = 339
};
enum : unsigned { kShort = 3, kLong = 4 };
constexpr unsigned kTopLeft = 1;

/// The fields of a TIFF's first directory (TIFF 6.0, Adobe 1992, section 2).
class Directory {
 public:
  Directory(const std::string& bytes, const std::string& file) : bytes_(bytes), file_(file) {
    if (!bytes.starts_with("II") && !bytes.starts_with("MM"))
      fail("found no TIFF, expected a depth image (grey, 16 bits)");
    is_low_first_ = bytes[0] == 'I';
    if (number(2, 2) != 42) fail("found no TIFF, expected a depth image (grey, 16 bits)");
    at_ = number(4, 4);
    count_ = number(at_, 2);
  }
  /// The first value of an integer field, or `missing`.
  unsigned value(unsigned field, unsigned missing) const {
    for (std::size_t i = 0; i < count_; ++i) {
      const std::size_t entry = at_ + 2 + 12 * i;
      if (number(entry, 2) != field) continue;
      const unsigned type = number(entry + 2, 2);
      if (type == kShort) return number(entry + 8, 2);
      if (type == kLong) return number(entry + 8, 4);
      fail("found field " + std::to_string(field) + " of type " + std::to_string(type) +
           ", expected a whole number");
    }
    return missing;
  }
  [[noreturn]] void fail(const std::string& message) const { throw ParseError({file_}, message); }

 private:
  unsigned number(std::size_t at, std::size_t size) const {
    if (at > bytes_.size() || bytes_.size() - at < size)
      fail("found the end at byte " + std::to_string(bytes_.size()) + ", expected the directory of a TIFF");
    unsigned value = 0;
    for (std::size_t i = 0; i < size; ++i)
      value = value << 8 | static_cast<unsigned char>(bytes_[at + (is_low_first_ ? size - 1 - i : i)]);
    return value;
  }

  const std::string& bytes_;
  const std::string& file_;
  bool is_low_first_{true};
  std::size_t at_{0}, count_{0};
};

}  // namespace

TiffSize checkDepthTiff(const std::string& bytes, const std::string& file) {
  const Directory directory(bytes, file);
  const unsigned width = directory.value(kWidth, 0), height = directory.value(kHeight, 0);
  const unsigned bits = directory.value(kBits, 1), channels = directory.value(kChannels, 1);
  const unsigned form = directory.value(kSampleFormat, 1);
  if (bits != 16 || channels != 1 || form != 1)
    directory.fail("found a TIFF of " + std::to_string(channels) + " channels of " + std::to_string(bits) +
                   " bits, sample format " + std::to_string(form) +
                   ", expected one of 16 bits of whole numbers (1)");
  if (const unsigned orientation = directory.value(kOrientation, kTopLeft); orientation != kTopLeft)
    directory.fail("found a TIFF with orientation " + std::to_string(orientation) +
                   ", expected an upright one (1)");
  if (width == 0 || height == 0 || width > DepthCamera::kMaxPixels || height > DepthCamera::kMaxPixels)
    directory.fail("found " + std::to_string(width) + " x " + std::to_string(height) +
                   " pixels, expected 1 to " + std::to_string(DepthCamera::kMaxPixels) + " along a side");
  return {static_cast<int>(width), static_cast<int>(height)};
}

DepthImage decodeDepthTiff(const std::string& bytes, double scale, const std::string& file) {
  const TiffSize size = checkDepthTiff(bytes, file);
  const std::optional<GreyPixels> grey = decodedTiff(bytes);
  if (!grey || grey->width != size.width || grey->height != size.height)
    throw ParseError({file}, "found a damaged TIFF, expected a depth image (grey, 16 bits)");
  return depthOf(*grey, scale);
}

}  // namespace abstand::tracking
