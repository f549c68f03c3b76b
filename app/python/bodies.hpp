// Python types of meshes, shapes and structures.
#pragma once

#include <pybind11/numpy.h>

#include <memory>

#include "core/mesh_file/mesh_report.hpp"
#include "core/structure/haptic_structure.hpp"

namespace abstand::python {

namespace py = pybind11;

/// abstand.Mesh: welded and immutable, so that views stay valid.
struct Mesh {
  geometry::TriangleMesh mesh;
  mesh_file::MeshReport report;
};

/// abstand.Shape; a struct, because a bare std::variant would be converted to its alternatives.
struct ShapeBody {
  geometry::Shape shape;
};

/// abstand.Structure. Arrays are created on first access.
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
