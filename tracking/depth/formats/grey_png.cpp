#include "tracking/depth/formats/grey_png.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"
#include "core/base/text_file.hpp"
#include "tracking/depth/formats/png_codec.hpp"
#include "tracking/depth/formats/png_header.hpp"

namespace abstand::tracking {
namespace {

constexpr std::uintmax_t kMaxGreyPngBytes = std::uintmax_t{256} << 20;
constexpr double kWhite = 255.0;

}  // namespace

GreyImage loadGreyPng(const std::filesystem::path& file) {
  const std::string bytes = readFile(file, kMaxGreyPngBytes);
  readPngHeader(bytes, file.string(), "an image of grey or colour");
  const std::optional<GreyPixels> grey = decodedPng(bytes);
  if (!grey) throw ParseError({file.string()}, "found a damaged PNG, expected an image of grey or colour");
  const double brightest = *std::max_element(grey->values.begin(), grey->values.end());
  const double scale = grey->bits == 16 && brightest > 0.0 ? kWhite / brightest : 1.0;
  GreyImage image(grey->width, grey->height);
  std::transform(grey->values.begin(), grey->values.end(), image.pixels.begin(),
                 [scale](std::uint16_t v) { return static_cast<std::uint8_t>(std::lround(scale * v)); });
  return image;
}

}  // namespace abstand::tracking
