// Wraps libpng: pictures in memory. The large collections of image formats load a hundred further libraries,
// which would take most of the time in which a command starts.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>

#include "tracking/depth/formats/grey_pixels.hpp"

namespace abstand::tracking {

/// Decodes a PNG, whose header was checked (png_header.hpp), to grey: colours become 0.299 R + 0.587 G +
/// 0.114 B, transparency is dropped, fewer than 8 bits become 8. Empty for a damaged picture.
std::optional<GreyPixels> decodedPng(const std::string& bytes);

/// The bytes of a file: 16 bits of grey, or 8 bits of red, green and blue, row by row from the top.
std::string encodedPng(int width, int height, std::span<const std::uint16_t> grey);
std::string encodedPng(int width, int height, std::span<const std::array<std::uint8_t, 3>> colours);

}  // namespace abstand::tracking
