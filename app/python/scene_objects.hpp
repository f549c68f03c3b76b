// Parts of the module abstand._scene.
#pragma once

#include <pybind11/pybind11.h>

namespace abstand::python {

namespace py = pybind11;

void bindRecordings(py::module_& module);
void bindResults(py::module_& module);
void bindScenes(py::module_& module);

}  // namespace abstand::python
