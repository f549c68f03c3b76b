// The library itself: its version, and the files that came with it.
#pragma once

#include <filesystem>

namespace abstand {

/// Of the library that runs, "0.2.0"; two that differ before the last point do not share a binary interface.
const char* version();

/// The folder with robots, joint maps and example scenes: the environment's ABSTAND_DATA, else that of the
/// source which the library was built from while it exists, else share/abstand beside the program's folder or
/// where the library was installed to. It need not exist. Any thread.
std::filesystem::path dataDirectory();

}  // namespace abstand
