// Translates errors of the project to Python exceptions.
#pragma once

#include <pybind11/pybind11.h>

namespace abstand::python {

/// Registers the translation of ParseError, UsageError and WriteError to abstand.ParseError,
/// abstand.UsageError and abstand.WriteError, with the same text.
void translateErrors();

}  // namespace abstand::python
