// Version and data files of the library.
#pragma once

#include <filesystem>

namespace abstand {

/// Version of the loaded library, "0.2.0". Versions that differ in the first two numbers are not binary
/// compatible.
const char* version();

/// The folder with robots, joint maps and example scenes: the environment variable ABSTAND_DATA; otherwise
/// the data folder of the source tree from which the library was built, if it exists; otherwise share/abstand
/// beside the folder of the program or in the installation folder. It may be missing. Any thread.
std::filesystem::path dataDirectory();

}  // namespace abstand
