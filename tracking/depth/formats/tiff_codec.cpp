#include "tracking/depth/formats/tiff_codec.hpp"

#include <tiffio.h>

#include <algorithm>
#include <cstring>
#include <memory>

#include "tracking/depth/camera/depth_camera.hpp"

namespace abstand::tracking {
namespace {

// TiffBytes of one allocation of the library: a picture of the largest size.
constexpr tmsize_t kMaxTiffBytes = tmsize_t{2} * DepthCamera::kMaxPixels * DepthCamera::kMaxPixels;

/// A file in memory, as the library reads it.
struct TiffBytes {
  const std::string& all;
  toff_t at{0};
};

TiffBytes& tiffBytesOf(thandle_t handle) { return *static_cast<TiffBytes*>(handle); }

tmsize_t takeTiff(thandle_t handle, void* to, tmsize_t count) {
  TiffBytes& bytes = tiffBytesOf(handle);
  if (count <= 0 || bytes.at >= bytes.all.size()) return 0;
  const auto size = std::min<std::size_t>(static_cast<std::size_t>(count), bytes.all.size() - bytes.at);
  std::memcpy(to, bytes.all.data() + bytes.at, size);
  bytes.at += size;
  return static_cast<tmsize_t>(size);
}

tmsize_t refuseTiff(thandle_t, void*, tmsize_t) { return 0; }

toff_t seekTiff(thandle_t handle, toff_t offset, int whence) {
  TiffBytes& bytes = tiffBytesOf(handle);
  const toff_t from = whence == SEEK_CUR ? bytes.at : whence == SEEK_END ? bytes.all.size() : 0;
  return bytes.at = from + offset;
}

int keepOpen(thandle_t) { return 0; }
toff_t sizeOfTiff(thandle_t handle) { return tiffBytesOf(handle).all.size(); }
int noMap(thandle_t, void**, toff_t*) { return 0; }
void noUnmap(thandle_t, void*, toff_t) {}
int silentTiff(TIFF*, void*, const char*, const char*, va_list) { return 1; }

using Tiff = std::unique_ptr<TIFF, decltype(&TIFFClose)>;

Tiff openedTiff(TiffBytes& bytes) {
  const std::unique_ptr<TIFFOpenOptions, decltype(&TIFFOpenOptionsFree)> options(TIFFOpenOptionsAlloc(),
                                                                                 TIFFOpenOptionsFree);
  TIFFOpenOptionsSetMaxSingleMemAlloc(options.get(), kMaxTiffBytes);
  TIFFOpenOptionsSetErrorHandlerExtR(options.get(), silentTiff, nullptr);
  TIFFOpenOptionsSetWarningHandlerExtR(options.get(), silentTiff, nullptr);
  return {TIFFClientOpenExt("", "r", &bytes, takeTiff, refuseTiff, seekTiff, keepOpen, sizeOfTiff, noMap,
                            noUnmap, options.get()),
          TIFFClose};
}

/// A rectangle of pixels that the file stores together: a strip or a tile.
struct TiffBlock {
  std::size_t x, y, width, height;
};

/// Copies the part of a block that lies in the picture.
void copyBlock(const TiffBlock& block, const std::vector<std::uint16_t>& from, GreyPixels& to) {
  const auto width = static_cast<std::size_t>(to.width), height = static_cast<std::size_t>(to.height);
  for (std::size_t v = 0; v < block.height && block.y + v < height; ++v)
    std::copy_n(from.begin() + static_cast<std::ptrdiff_t>(v * block.width),
                std::min(block.width, width - block.x),
                to.values.begin() + static_cast<std::ptrdiff_t>((block.y + v) * width + block.x));
}

bool readStrips(TIFF* tiff, GreyPixels& grey) {
  std::uint32_t rows = 0;
  TIFFGetFieldDefaulted(tiff, TIFFTAG_ROWSPERSTRIP, &rows);
  const auto width = static_cast<std::size_t>(grey.width), height = static_cast<std::size_t>(grey.height);
  const std::size_t step = std::min<std::size_t>(rows, height);
  if (step == 0) return false;
  std::vector<std::uint16_t> strip(width * step);
  for (std::size_t y = 0; y < height; y += step) {
    const std::size_t count = std::min(step, height - y);
    const auto size = static_cast<tmsize_t>(2 * width * count);
    if (TIFFReadEncodedStrip(tiff, TIFFComputeStrip(tiff, static_cast<std::uint32_t>(y), 0), strip.data(),
                             size) != size)
      return false;
    copyBlock({0, y, width, count}, strip, grey);
  }
  return true;
}

bool readTiles(TIFF* tiff, GreyPixels& grey) {
  std::uint32_t wide = 0, high = 0;
  TIFFGetField(tiff, TIFFTAG_TILEWIDTH, &wide);
  TIFFGetField(tiff, TIFFTAG_TILELENGTH, &high);
  // A tile that is larger than every picture may not takeTiff its memory.
  if (wide == 0 || high == 0 || wide > 2u * DepthCamera::kMaxPixels || high > 2u * DepthCamera::kMaxPixels)
    return false;
  std::vector<std::uint16_t> tile(static_cast<std::size_t>(wide) * high);
  const auto size = static_cast<tmsize_t>(2 * tile.size());
  if (TIFFTileSize(tiff) != size) return false;
  for (std::uint32_t y = 0; y < static_cast<std::uint32_t>(grey.height); y += high)
    for (std::uint32_t x = 0; x < static_cast<std::uint32_t>(grey.width); x += wide) {
      if (TIFFReadEncodedTile(tiff, TIFFComputeTile(tiff, x, y, 0, 0), tile.data(), size) != size)
        return false;
      copyBlock({x, y, wide, high}, tile, grey);
    }
  return true;
}

}  // namespace

std::optional<GreyPixels> decodedTiff(const std::string& bytes) {
  TiffBytes source{bytes};
  const Tiff tiff = openedTiff(source);
  if (!tiff) return std::nullopt;
  std::uint32_t width = 0, height = 0;
  std::uint16_t orientation = 0, bits = 0, channels = 0;
  TIFFGetField(tiff.get(), TIFFTAG_IMAGEWIDTH, &width);
  TIFFGetField(tiff.get(), TIFFTAG_IMAGELENGTH, &height);
  TIFFGetFieldDefaulted(tiff.get(), TIFFTAG_ORIENTATION, &orientation);
  TIFFGetFieldDefaulted(tiff.get(), TIFFTAG_BITSPERSAMPLE, &bits);
  TIFFGetFieldDefaulted(tiff.get(), TIFFTAG_SAMPLESPERPIXEL, &channels);
  if (width == 0 || height == 0 || width > DepthCamera::kMaxPixels || height > DepthCamera::kMaxPixels ||
      orientation != ORIENTATION_TOPLEFT || bits != 16 || channels != 1)
    return std::nullopt;
  GreyPixels grey;
  grey.width = static_cast<int>(width);
  grey.height = static_cast<int>(height);
  grey.bits = 16;
  grey.values.resize(static_cast<std::size_t>(width) * height);
  const bool complete =
      TIFFIsTiled(tiff.get()) != 0 ? readTiles(tiff.get(), grey) : readStrips(tiff.get(), grey);
  return complete ? std::optional(std::move(grey)) : std::nullopt;
}

}  // namespace abstand::tracking
