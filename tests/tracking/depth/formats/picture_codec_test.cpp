// PNG and TIFF in memory: what is written is read, and every cut of a file is refused.
#include <gtest/gtest.h>
#include <tiffio.h>

#include "core/base/text_file.hpp"
#include "tests/support/paths.hpp"
#include "tracking/depth/formats/png_codec.hpp"
#include "tracking/depth/formats/tiff_codec.hpp"

namespace abstand::tracking {
namespace picture_codec_test {

constexpr int kWidth = 37, kHeight = 23;

/// Values over the whole range, different in each row and column.
std::vector<std::uint16_t> depthValues() {
  std::vector<std::uint16_t> values;
  for (int i = 0; i < kWidth * kHeight; ++i)
    values.push_back(static_cast<std::uint16_t>(40503u * static_cast<unsigned>(i)));
  return values;
}

TEST(PngCodec, ReadsWhatItWrites) {
  const std::vector<std::uint16_t> values = depthValues();
  const auto read = decodedPng(encodedPng(kWidth, kHeight, values));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->width, kWidth);
  EXPECT_EQ(read->height, kHeight);
  EXPECT_EQ(read->bits, 16);
  EXPECT_EQ(read->values, values);
}

TEST(PngCodec, ColoursBecomeGreyByTheirLuma) {
  const std::vector<std::array<std::uint8_t, 3>> colours{{255, 255, 255}, {0, 0, 0},   {255, 0, 0},
                                                         {0, 255, 0},     {0, 0, 255}, {9, 9, 9}};
  const auto read = decodedPng(encodedPng(3, 2, colours));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->bits, 8);
  ASSERT_EQ(read->values.size(), colours.size());
  for (std::size_t i = 0; i < colours.size(); ++i)
    EXPECT_NEAR(read->values[i], 0.299 * colours[i][0] + 0.587 * colours[i][1] + 0.114 * colours[i][2], 1.0)
        << i;
}

TEST(PngCodec, RefusesEveryCutAndChangedByte) {
  const std::string bytes = encodedPng(kWidth, kHeight, depthValues());
  // The signature, the checksum of each chunk and the end are all needed.
  for (std::size_t length = 0; length < bytes.size(); ++length)
    EXPECT_FALSE(decodedPng(bytes.substr(0, length))) << length;
  for (std::size_t at = 0; at < bytes.size(); at += 7) {
    std::string changed = bytes;
    changed[at] = static_cast<char>(changed[at] ^ 0x10);
    EXPECT_FALSE(decodedPng(changed)) << at;
  }
}

struct TiffCase {
  const char* name;
  std::uint16_t compression;
  bool tiled;
};

class TiffCodec : public ::testing::TestWithParam<TiffCase> {
 protected:
  /// Written by libtiff itself.
  std::string bytes(std::uint16_t orientation = ORIENTATION_TOPLEFT) const {
    const std::string file = (folder_.path() / "a.tiff").string();
    TIFF* tiff = TIFFOpen(file.c_str(), "w");
    TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, kWidth);
    TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, kHeight);
    TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 16);
    TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, 1);
    TIFFSetField(tiff, TIFFTAG_COMPRESSION, GetParam().compression);
    TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
    TIFFSetField(tiff, TIFFTAG_ORIENTATION, orientation);
    const std::vector<std::uint16_t> values = depthValues();
    if (GetParam().tiled)
      writeTiles(tiff, values);
    else
      writeStrips(tiff, values);
    TIFFClose(tiff);
    return readFile(file);
  }

 private:
  static void writeStrips(TIFF* tiff, std::vector<std::uint16_t> values) {
    TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, 5);
    for (std::uint32_t v = 0; v < kHeight; ++v)
      EXPECT_EQ(TIFFWriteScanline(tiff, values.data() + v * kWidth, v), 1);
  }
  static void writeTiles(TIFF* tiff, const std::vector<std::uint16_t>& values) {
    constexpr std::uint32_t kTile = 16;
    TIFFSetField(tiff, TIFFTAG_TILEWIDTH, kTile);
    TIFFSetField(tiff, TIFFTAG_TILELENGTH, kTile);
    for (std::uint32_t y = 0; y < kHeight; y += kTile)
      for (std::uint32_t x = 0; x < kWidth; x += kTile) {
        std::vector<std::uint16_t> tile(std::size_t{kTile} * kTile, 9);
        for (std::uint32_t v = 0; v < kTile && y + v < kHeight; ++v)
          for (std::uint32_t u = 0; u < kTile && x + u < kWidth; ++u)
            tile[v * kTile + u] = values[(y + v) * kWidth + x + u];
        EXPECT_GE(TIFFWriteTile(tiff, tile.data(), x, y, 0, 0), 0);
      }
  }

  testing::ScratchFolder folder_;
};

TEST_P(TiffCodec, ReadsStripsAndTiles) {
  const auto read = decodedTiff(bytes());
  ASSERT_TRUE(read);
  EXPECT_EQ(read->width, kWidth);
  EXPECT_EQ(read->height, kHeight);
  EXPECT_EQ(read->values, depthValues());
}

TEST_P(TiffCodec, RefusesCutsAndOtherOrientations) {
  EXPECT_FALSE(decodedTiff(bytes(ORIENTATION_BOTLEFT)));
  EXPECT_FALSE(decodedTiff(bytes(ORIENTATION_RIGHTTOP)));
  const std::string whole = bytes();
  // The directory is at the end, so that each cut loses a part of it or of what it points to.
  for (std::size_t length = 0; length < whole.size() - 8; length += 3)
    EXPECT_FALSE(decodedTiff(whole.substr(0, length))) << length;
}

INSTANTIATE_TEST_SUITE_P(Pictures, TiffCodec,
                         ::testing::Values(TiffCase{"plain_strips", COMPRESSION_NONE, false},
                                           TiffCase{"lzw_strips", COMPRESSION_LZW, false},
                                           TiffCase{"plain_tiles", COMPRESSION_NONE, true},
                                           TiffCase{"deflated_tiles", COMPRESSION_ADOBE_DEFLATE, true}),
                         [](const auto& c) { return std::string(c.param.name); });

}  // namespace picture_codec_test
}  // namespace abstand::tracking
