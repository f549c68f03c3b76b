#include "tracking/depth/formats/colour_png.hpp"

#include "core/base/output_file.hpp"
#include "tracking/depth/formats/png_codec.hpp"

namespace abstand::tracking {

void saveColourPng(const ColourImage& image, const std::filesystem::path& file) {
  OutputFile out(file);
  out.stream() << encodedPng(image.width, image.height, image.pixels);
  out.commit();
}

}  // namespace abstand::tracking
