// The parameter section of a C3D file.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "tracking/c3d/c3d_bytes.hpp"
#include "tracking/recording/file_warning.hpp"

namespace abstand::tracking {

/// One parameter: numbers, or texts.
struct C3dParameter {
  std::vector<double> numbers;
  std::vector<std::string> texts;  ///< without the blanks at their ends
};

/// By "GROUP:NAME" in capitals.
using C3dParameters = std::map<std::string, C3dParameter>;

/// Reads the section that begins at byte `start`; the processor of `bytes` must be set. Every record is taken
/// by the offset that the one before gives, which must lead on: what follows a record that does not, or one
/// that is longer than the file, is left out with a warning.
C3dParameters readC3dParameters(const C3dBytes& bytes, std::size_t start, std::vector<FileWarning>& warnings);

}  // namespace abstand::tracking
