// abstand._engine: what `import abstand` loads.
#include "app/python/bodies.hpp"
#include "app/python/error_translation.hpp"

PYBIND11_MODULE(_engine, module) {
  // Sets the module name that users see in classes and functions.
  module.attr("__module__") = "abstand";
  module.doc() = "The engine of abstand: bodies, distances, contacts, mechanisms, people.";
  abstand::python::translateErrors();
  abstand::python::bindMeshes(module);
  abstand::python::bindStructures(module);
  abstand::python::bindQueries(module);
  abstand::python::bindMechanisms(module);
  abstand::python::bindHumans(module);
}
