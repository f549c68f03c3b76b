// Reads NumPy arrays.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace abstand::tracking {

/// View of an array in memory: sizes of its axes, and its numbers in sequence, the last axis fastest.
struct NpyArray {
  std::vector<std::size_t> size;
  char kind{'f'};             ///< 'u' or 'i': integers; 'f': floating point
  std::size_t bytes_each{0};  ///< 1 to 8
  bool is_low_first{true};
  std::string_view data;  ///< part of the file's bytes

  /// Number `i` in sequence.
  double at(std::size_t i) const;
};

/// Versions 1 to 3 of the format (numpy.lib.format); integers of 1, 2, 4, 8 bytes, floating point of 2, 4, 8;
/// C order (not Fortran order). `bytes` must outlive the array. Throws ParseError.
NpyArray parseNpy(std::string_view bytes, const std::string& file);

}  // namespace abstand::tracking
