// The thesis's mechanism configuration file.
#pragma once

#include <filesystem>
#include <string>

#include "core/mechanism/mechanism.hpp"

namespace abstand {

/// Reads a `.mech` file [thesis 3.1.4]. Throws ParseError with file, line and column.
Mechanism loadMechanism(const std::filesystem::path& file);

/// The same from text; `name` stands for the file in messages.
Mechanism parseMechanism(const std::string& text, const std::string& name);

}  // namespace abstand
