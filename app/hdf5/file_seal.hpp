// A checksum in front of an HDF5 file, so that no damaged file reaches the library.
#pragma once

#include <filesystem>
#include <string>

namespace abstand::hdf5 {

/// Bytes in front of the library's own ("user block"), which every reader of HDF5 skips.
inline constexpr std::size_t kSealBytes = 512;

/// Writes the checksum (XXH3, 128 bits) of all that lies behind it. Throws WriteError.
void seal(const std::filesystem::path& file);

/// Empty, or what is wrong with the file: "found ..., expected ...". Throws nothing but ParseError.
std::string brokenSeal(const std::filesystem::path& file);

}  // namespace abstand::hdf5
