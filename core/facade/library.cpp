#include "abstand/library.hpp"

#include "core/base/data_folder.hpp"

namespace abstand {

const char* version() { return ABSTAND_VERSION; }

std::filesystem::path dataDirectory() { return dataFolder(); }

}  // namespace abstand
