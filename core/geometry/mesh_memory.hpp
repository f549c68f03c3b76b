// A mesh file that is in memory already; internal to core/geometry and the fuzzers.
#pragma once

#include <string>

#include "core/geometry/mesh_file.hpp"

namespace abstand {

/// As loadMesh(), from the file's bytes; `extension` in lower case tells the format, `name` stands for the
/// file in messages.
LoadedMesh readMesh(const std::string& bytes, const std::string& extension, const std::string& name,
                    double scale);

}  // namespace abstand
