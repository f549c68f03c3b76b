// Finds the data files that come with the program.
#pragma once

#include <filesystem>

namespace abstand {

/// The folder with robots, joint maps, tables and example scenes. The first that applies: the environment
/// variable ABSTAND_DATA, if set and not empty; the `data` folder of the source tree that this program was
/// built from, if it exists (packaged builds skip this); `../share/abstand` beside the program's own folder,
/// if it exists; the installation folder of the library. Any thread.
std::filesystem::path dataFolder();

}  // namespace abstand
