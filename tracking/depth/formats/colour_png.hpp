// Writes colour pictures as PNG.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace abstand::tracking {

/// Red, green, blue, row by row from the top.
struct ColourImage {
  int width{0}, height{0};
  std::vector<std::array<std::uint8_t, 3>> pixels;

  ColourImage(int w, int h)
      : width(w), height(h), pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}
  std::array<std::uint8_t, 3>& at(int u, int v) { return pixels[static_cast<std::size_t>(v * width + u)]; }
};

/// Written completely or not at all. Throws UsageError if the file cannot be written.
void saveColourPng(const ColourImage& image, const std::filesystem::path& file);

}  // namespace abstand::tracking
