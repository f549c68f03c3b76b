// What Python holds: meshes, shapes and structures.
#pragma once

#include <pybind11/numpy.h>

#include <memory>

#include "core/mesh_file/mesh_report.hpp"
#include "core/structure/haptic_structure.hpp"

namespace abstand::python {

namespace py = pybind11;

/// abstand.Mesh: welded, constant after it is made, so that views of it stay right.
struct Mesh {
  geometry::TriangleMesh mesh;
  mesh_file::MeshReport report;
};

/// abstand.Shape; a std::variant of its own would be taken apart on the way.
struct ShapeBody {
  geometry::Shape shape;
};

/// abstand.Structure. The arrays are made when they are asked for first.
struct Structure {
  std::shared_ptr<const structure::HapticStructure> haptic;
  py::object points, normals;
};

void bindMeshes(py::module_& module);
void bindStructures(py::module_& module);
void bindQueries(py::module_& module);
void bindMechanisms(py::module_& module);
void bindHumans(py::module_& module);

}  // namespace abstand::python
