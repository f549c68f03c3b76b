// abstand._engine: what `import abstand` loads.
#include "app/python/bodies.hpp"
#include "app/python/error_translation.hpp"

PYBIND11_MODULE(_engine, module) {
  // What users see of its classes and functions is where they find them.
  module.attr("__module__") = "abstand";
  module.doc() = "The engine of abstand: bodies, distances, contacts, mechanisms, people.";
  abstand::python::translateErrors();
  abstand::python::bindMeshes(module);
  abstand::python::bindStructures(module);
  abstand::python::bindQueries(module);
  abstand::python::bindMechanisms(module);
  abstand::python::bindHumans(module);
}
