// Errors of the project as Python exceptions.
#pragma once

#include <pybind11/pybind11.h>

namespace abstand::python {

/// From now on ParseError, UsageError and WriteError that leave a function of this extension become
/// abstand.ParseError, abstand.UsageError and abstand.WriteError, with the same text.
void translateErrors();

}  // namespace abstand::python
