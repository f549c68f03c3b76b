// Checksum of an HDF5 file, so that no damaged file reaches the library.
#pragma once

#include <filesystem>
#include <string>

namespace abstand::hdf5 {

/// Size of the "user block" before the library's own bytes, which every HDF5 reader skips.
inline constexpr std::size_t kSealBytes = 512;

/// Writes the checksum (XXH3, 128 bits) of everything after the block. Throws WriteError.
void seal(const std::filesystem::path& file);

/// Empty, or the fault of the file: "found ..., expected ...". Throws nothing but ParseError.
std::string brokenSeal(const std::filesystem::path& file);

}  // namespace abstand::hdf5
