#include "tracking/depth/formats/depth_png.hpp"

#include <cmath>
#include <cstdint>

#include "core/base/error.hpp"
#include "core/base/output_file.hpp"
#include "core/base/text_file.hpp"
#include "tracking/depth/formats/depth_of_grey.hpp"
#include "tracking/depth/formats/png_codec.hpp"
#include "tracking/depth/formats/png_header.hpp"

namespace abstand::tracking {
namespace {

constexpr double kMax = 65535.0;
constexpr std::uintmax_t kMaxDepthPngBytes = std::uintmax_t{256} << 20;
/// Checks the header before the decoder allocates memory for untrusted sizes.
void checkHeader(const std::string& bytes, const std::string& file) {
  const PngHeader header = readPngHeader(bytes, file, "a depth image (grey, 16 bits)");
  if (header.bits != 16 || header.colour != 0)
    throw ParseError({file}, "found a PNG of " + std::to_string(header.bits) + " bits and colour type " +
                                 std::to_string(header.colour) + ", expected 16 bits of grey (type 0)");
}

}  // namespace

void saveDepthPng(const DepthImage& image, double scale, const std::filesystem::path& file) {
  std::vector<std::uint16_t> grey;
  for (int v = 0; v < image.height; ++v) {
    for (int u = 0; u < image.width; ++u) {
      const double units = std::round(image.at(u, v) * scale);
      // The comparisons turn NaN into 0.
      grey.push_back(units >= 1.0 && units <= kMax ? static_cast<std::uint16_t>(units) : std::uint16_t{0});
    }
  }
  OutputFile out(file);
  out.stream() << encodedPng(image.width, image.height, grey);
  out.commit();
}

DepthImage loadDepthPng(const std::filesystem::path& file, double scale) {
  const std::string bytes = readFile(file, kMaxDepthPngBytes);
  checkHeader(bytes, file.string());
  const std::optional<GreyPixels> grey = decodedPng(bytes);
  if (!grey || grey->bits != 16)
    throw ParseError({file.string()}, "found a damaged PNG, expected a depth image (grey, 16 bits)");
  return depthOf(*grey, scale);
}

}  // namespace abstand::tracking
