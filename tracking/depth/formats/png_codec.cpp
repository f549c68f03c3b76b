#include "tracking/depth/formats/png_codec.hpp"

#include <png.h>
#include <zlib.h>

#include <algorithm>
#include <csetjmp>
#include <cstring>

#include "core/base/error.hpp"
#include "tracking/depth/camera/depth_camera.hpp"

namespace abstand::tracking {
namespace {

// Weights of red and green in grey [ITU-R BT.601].
constexpr double kRed = 0.299, kGreen = 0.587;
// PngBytes that text and profiles in a file may takePng when they are unpacked.
constexpr png_alloc_size_t kMaxChunk = 1u << 20;

struct PngBytes {
  const unsigned char* at;
  std::size_t left;
};

[[noreturn]] void leavePng(png_structp png, png_const_charp) { png_longjmp(png, 1); }
void ignorePng(png_structp, png_const_charp) {}

void takePng(png_structp png, png_bytep to, png_size_t count) {
  auto& bytes = *static_cast<PngBytes*>(png_get_io_ptr(png));
  if (count > bytes.left) png_error(png, "end of the file");
  std::memcpy(to, bytes.at, count);
  bytes.at += count;
  bytes.left -= count;
}

void appendPng(png_structp png, png_bytep from, png_size_t count) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(from), count);
}

void flushPng(png_structp) {}

/// The state of libpng while it reads. Its errors jump (setjmp), so the functions below have no objects to
/// destroy.
struct PngReader {
  PngReader() : png(png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, leavePng, ignorePng)) {
    if (png) info = png_create_info_struct(png);
    if (!info) throw std::bad_alloc();
  }
  ~PngReader() { png_destroy_read_struct(&png, &info, nullptr); }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;

  png_structp png;
  png_infop info{nullptr};
};

struct PngWriter {
  PngWriter() : png(png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, leavePng, ignorePng)) {
    if (png) info = png_create_info_struct(png);
    if (!info) throw std::bad_alloc();
  }
  ~PngWriter() { png_destroy_write_struct(&png, &info); }
  PngWriter(const PngWriter&) = delete;
  PngWriter& operator=(const PngWriter&) = delete;

  png_structp png;
  png_infop info{nullptr};
};

/// Reads up to the pixels, and asks for rows of grey with 8 or 16 bits.
bool readInfo(png_structp png, png_infop info) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_read_info(png, info);
  const int colour = png_get_color_type(png, info), bits = png_get_bit_depth(png, info);
  png_set_strip_alpha(png);
  if (colour == PNG_COLOR_TYPE_PALETTE) png_set_palette_to_rgb(png);
  if (colour == PNG_COLOR_TYPE_GRAY && bits < 8) png_set_expand_gray_1_2_4_to_8(png);
  if ((colour & PNG_COLOR_MASK_COLOR) != 0) png_set_rgb_to_gray(png, PNG_ERROR_ACTION_NONE, kRed, kGreen);
  png_set_interlace_handling(png);
  png_read_update_info(png, info);
  return png_get_channels(png, info) == 1;
}

bool readRows(png_structp png, png_bytepp rows) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_read_image(png, rows);
  png_read_end(png, nullptr);
  return true;
}

struct PictureShape {
  int width, height, bits, colour;
};

bool writePicture(png_structp png, png_infop info, const PictureShape& shape, png_bytepp rows) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_SUB);
  png_set_compression_level(png, Z_BEST_SPEED);
  png_set_compression_strategy(png, Z_RLE);
  png_set_IHDR(png, info, static_cast<png_uint_32>(shape.width), static_cast<png_uint_32>(shape.height),
               shape.bits, shape.colour, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  png_write_info(png, info);
  png_write_image(png, rows);
  png_write_end(png, nullptr);
  return true;
}

std::vector<png_bytep> rowsOf(std::vector<unsigned char>& pixels, std::size_t height) {
  std::vector<png_bytep> rows(height);
  for (std::size_t v = 0; v < height; ++v) rows[v] = pixels.data() + v * (pixels.size() / height);
  return rows;
}

std::string encoded(const PictureShape& shape, std::vector<unsigned char> pixels) {
  std::string bytes;
  std::vector<png_bytep> rows = rowsOf(pixels, static_cast<std::size_t>(shape.height));
  const PngWriter writer;
  png_set_write_fn(writer.png, &bytes, appendPng, flushPng);
  ABSTAND_CHECK(writePicture(writer.png, writer.info, shape, rows.data()));
  return bytes;
}

}  // namespace

std::optional<GreyPixels> decodedPng(const std::string& bytes) {
  PngBytes source{reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()};
  const PngReader reader;
  png_set_user_limits(reader.png, DepthCamera::kMaxPixels, DepthCamera::kMaxPixels);
  png_set_chunk_malloc_max(reader.png, kMaxChunk);
  png_set_read_fn(reader.png, &source, takePng);
  if (!readInfo(reader.png, reader.info)) return std::nullopt;
  GreyPixels grey;
  grey.width = static_cast<int>(png_get_image_width(reader.png, reader.info));
  grey.height = static_cast<int>(png_get_image_height(reader.png, reader.info));
  grey.bits = png_get_bit_depth(reader.png, reader.info);
  const auto width = static_cast<std::size_t>(grey.width), height = static_cast<std::size_t>(grey.height);
  const std::size_t size = grey.bits == 16 ? 2 : 1;
  if (png_get_rowbytes(reader.png, reader.info) != width * size) return std::nullopt;
  std::vector<unsigned char> pixels(width * height * size);
  std::vector<png_bytep> rows = rowsOf(pixels, height);
  if (!readRows(reader.png, rows.data())) return std::nullopt;
  grey.values.resize(width * height);
  for (std::size_t i = 0; i < grey.values.size(); ++i)
    grey.values[i] =
        size == 2 ? static_cast<std::uint16_t>(pixels[2 * i] << 8 | pixels[2 * i + 1]) : pixels[i];
  return grey;
}

std::string encodedPng(int width, int height, std::span<const std::uint16_t> grey) {
  std::vector<unsigned char> pixels;
  pixels.reserve(2 * grey.size());
  for (const std::uint16_t value : grey)
    pixels.insert(pixels.end(),
                  {static_cast<unsigned char>(value >> 8), static_cast<unsigned char>(value & 0xff)});
  return encoded({width, height, 16, PNG_COLOR_TYPE_GRAY}, std::move(pixels));
}

std::string encodedPng(int width, int height, std::span<const std::array<std::uint8_t, 3>> colours) {
  std::vector<unsigned char> pixels;
  pixels.reserve(3 * colours.size());
  for (const auto& colour : colours) pixels.insert(pixels.end(), colour.begin(), colour.end());
  return encoded({width, height, 8, PNG_COLOR_TYPE_RGB}, std::move(pixels));
}

}  // namespace abstand::tracking
