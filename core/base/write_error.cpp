#include "core/base/write_error.hpp"

#include <system_error>

namespace abstand {

WriteError::WriteError(const std::string& name, int error)
    : WriteError(
          name, error == 0 ? std::string("the system refused it") : std::generic_category().message(error)) {}

}  // namespace abstand
