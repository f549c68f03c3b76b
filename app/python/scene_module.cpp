// abstand._scene: recordings and scenes, loaded on demand.
#include "app/python/error_translation.hpp"
#include "app/python/scene_objects.hpp"

PYBIND11_MODULE(_scene, module) {
  module.attr("__module__") = "abstand";
  module.doc() = "Recordings and scenes of abstand.";
  abstand::python::translateErrors();
  abstand::python::bindRecordings(module);
  abstand::python::bindResults(module);
  abstand::python::bindScenes(module);
}
