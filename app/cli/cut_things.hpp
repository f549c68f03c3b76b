// Options about the scene's robots and objects in depth images, for all commands that read recordings.
#pragma once

#include <optional>

#include "app/cli/command_line.hpp"

namespace abstand::cli {

/// --cut-things and --no-cut-things: whether robots and objects are removed; neither: if the images show
/// them.
void addCutThings(CLI::App& command, std::optional<bool>& cut_things);

}  // namespace abstand::cli
