// One variable of a MATLAB file.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace abstand::tracking {

/// Real numbers, column-major as in MATLAB.
struct MatVariable {
  std::vector<std::size_t> size;
  std::vector<double> values;
};

/// Reads a real array from a MATLAB file of version 5 to 7.2 (little endian, zlib-compressed or not;
/// "MAT-File Format", MathWorks, 2023). Stated sizes are checked against the available bytes, and at most 256
/// MB are decompressed. Throws ParseError, with the byte offset if known; if the variable does not exist,
/// with names and sizes of those that do.
MatVariable readMatVariable(std::string_view bytes, const std::string& name, const std::string& file);

}  // namespace abstand::tracking
