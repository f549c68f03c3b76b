// One variable of a MATLAB file.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace abstand::tracking {

/// Real numbers, column-major as MATLAB keeps them.
struct MatVariable {
  std::vector<std::size_t> size;
  std::vector<double> values;
};

/// Reads an array of real numbers from a MATLAB file of version 5 to 7.2 (little end first, packed by zlib or
/// not; "MAT-File Format", MathWorks, 2023). Sizes are believed only where the bytes for them are there, and
/// nothing is unpacked beyond 256 MB. Throws ParseError, with the byte where one is known; where the variable
/// is not in the file, with the names and sizes of those that are.
MatVariable readMatVariable(std::string_view bytes, const std::string& name, const std::string& file);

}  // namespace abstand::tracking
