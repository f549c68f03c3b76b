// Mesh files given on the command line.
#pragma once

#include <filesystem>
#include <string>

#include "core/robot_file/mesh_reference.hpp"

namespace abstand::cli {

/// Resolves `text`: a path, or a reference as in robot files, `package://NAME/REST`, `model://NAME/REST` or
/// `file:///PATH`, searched as for a robot file in the working folder. Throws ParseError if a package does
/// not have it.
std::filesystem::path meshArgument(const std::string& text, const robot_file::PackagePaths& packages);

}  // namespace abstand::cli
