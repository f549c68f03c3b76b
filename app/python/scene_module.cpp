// abstand._scene.
#include <pybind11/pybind11.h>

PYBIND11_MODULE(_scene, module) { module.doc() = "Recordings and scenes."; }
