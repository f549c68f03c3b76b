// The parameter section of a C3D file.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "tracking/c3d/c3d_bytes.hpp"
#include "tracking/recording/file_warning.hpp"

namespace abstand::tracking {

/// One parameter: numbers or texts.
struct C3dParameter {
  std::vector<double> numbers;
  std::vector<std::string> texts;  ///< without trailing and leading blanks
};

/// Key: "GROUP:NAME" in capitals.
using C3dParameters = std::map<std::string, C3dParameter>;

/// Reads the section that begins at byte `start`; the processor of `bytes` must be set. Records are linked by
/// offsets, which must increase: after a record that violates this or exceeds the file, the rest is ignored
/// with a warning.
C3dParameters readC3dParameters(const C3dBytes& bytes, std::size_t start, std::vector<FileWarning>& warnings);

}  // namespace abstand::tracking
