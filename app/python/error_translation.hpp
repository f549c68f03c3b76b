// Errors of the project as Python exceptions.
#pragma once

#include <pybind11/pybind11.h>

namespace abstand::python {

/// From now on ParseError, UsageError, WriteError and BuildCancelled that leave a function of this extension
/// become abstand.ParseError, abstand.UsageError, abstand.WriteError and KeyboardInterrupt, with the same
/// text.
void translateErrors();

}  // namespace abstand::python
