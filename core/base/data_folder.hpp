// Where the files that the program brings along are found.
#pragma once

#include <filesystem>

namespace abstand {

/// The folder with robots, joint maps, tables and example scenes: the environment's ABSTAND_DATA where it is
/// set and not empty, else the `data` folder of the source that this program was built from while it exists
/// (packages do without), else `../share/abstand` beside the program's own folder where it is there, else
/// where the library was installed to. Any thread.
std::filesystem::path dataFolder();

}  // namespace abstand
