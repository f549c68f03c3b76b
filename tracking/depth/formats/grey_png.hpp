// Grey images, as infrared and colour cameras make them. A fence around OpenCV's image files, as depth_png
// is.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace abstand::tracking {

/// Brightness, row by row from the top.
struct GreyImage {
  int width{0}, height{0};
  std::vector<std::uint8_t> pixels;

  GreyImage(int w, int h)
      : width(w), height(h), pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}
  std::uint8_t at(int u, int v) const { return pixels[static_cast<std::size_t>(v * width + u)]; }
  std::uint8_t& at(int u, int v) { return pixels[static_cast<std::size_t>(v * width + u)]; }
};

/// A PNG of grey or colour. Images of 16 bits, of which infrared cameras use some, are stretched until the
/// brightest pixel is 255. Throws ParseError for what is no such image, and for sides above
/// DepthCamera::kMaxPixels.
GreyImage loadGreyPng(const std::filesystem::path& file);

}  // namespace abstand::tracking
