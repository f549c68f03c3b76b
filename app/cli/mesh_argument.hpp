// Mesh files that a command is given by name.
#pragma once

#include <filesystem>
#include <string>

#include "core/robot_file/mesh_reference.hpp"

namespace abstand::cli {

/// The file that `text` names: a path as it stands, or what robot files write, `package://NAME/REST`,
/// `model://NAME/REST` or `file:///PATH`, looked for as in a robot file of the working folder. Throws
/// ParseError where a package does not have it.
std::filesystem::path meshArgument(const std::string& text, const robot_file::PackagePaths& packages);

}  // namespace abstand::cli
