// abstand.Mesh, abstand.load_mesh, abstand.Shape and the five shapes.
#include <pybind11/stl/filesystem.h>

#include <cmath>

#include "app/python/array_view.hpp"
#include "app/python/bodies.hpp"
#include "core/base/error.hpp"
#include "core/mesh_file/mesh_file.hpp"

namespace abstand::python {
namespace {

using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Integers = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>;

// Share of the diagonal within which vertices are merged, as for mesh files.
constexpr double kSameVertex = 1e-6;

void needRowsOfThree(const py::array& array, const char* name) {
  if (array.ndim() != 2 || array.shape(1) != 3)
    throw UsageError(std::string(name) + ": found an array of " + std::to_string(array.ndim()) +
                     " dimensions, expected one of shape (n, 3)");
}

Mesh meshOf(const Doubles& vertices, const Integers& triangles) {
  needRowsOfThree(vertices, "vertices");
  needRowsOfThree(triangles, "triangles");
  geometry::TriangleMesh raw;
  const auto p = vertices.unchecked<2>();
  for (py::ssize_t i = 0; i < p.shape(0); ++i) {
    raw.vertices.emplace_back(p(i, 0), p(i, 1), p(i, 2));
    const Vector3d& v = raw.vertices.back();
    if (!v.allFinite() || v.cwiseAbs().maxCoeff() > mesh_file::kFarthestVertex)
      throw UsageError("vertices[" + std::to_string(i) + "]: found a number that is not finite or beyond " +
                       "1e6 m, expected metres");
  }
  const auto t = triangles.unchecked<2>();
  for (py::ssize_t i = 0; i < t.shape(0); ++i) {
    std::array<std::uint32_t, 3> corners{};
    for (int k = 0; k < 3; ++k) {
      if (t(i, k) < 0 || t(i, k) >= p.shape(0))
        throw UsageError("triangles[" + std::to_string(i) + "]: found the vertex " + std::to_string(t(i, k)) +
                         ", expected 0 to " + std::to_string(p.shape(0) - 1));
      corners[static_cast<std::size_t>(k)] = static_cast<std::uint32_t>(t(i, k));
    }
    raw.triangles.push_back(corners);
  }
  if (raw.triangles.empty()) throw UsageError("triangles: found none, expected at least one");
  Mesh out{geometry::weld(raw, kSameVertex * geometry::bounds(raw).extent().norm()), {}};
  out.report = mesh_file::inspect(out.mesh);
  return out;
}

py::array verticesOf(py::handle self) {
  const Mesh& m = py::cast<const Mesh&>(self);
  return viewOf(m.mesh.vertices.empty() ? nullptr : m.mesh.vertices[0].data(),
                {static_cast<py::ssize_t>(m.mesh.vertices.size()), 3}, {sizeof(Vector3d), sizeof(double)},
                self);
}

py::array trianglesOf(py::handle self) {
  const Mesh& m = py::cast<const Mesh&>(self);
  return viewOf(m.mesh.triangles.empty() ? nullptr : m.mesh.triangles[0].data(),
                {static_cast<py::ssize_t>(m.mesh.triangles.size()), 3},
                {3 * sizeof(std::uint32_t), sizeof(std::uint32_t)}, self);
}

ShapeBody valid(const geometry::Shape& shape) {
  geometry::validate(shape);
  return {shape};
}

py::tuple dimensionsOf(const ShapeBody& s) {
  constexpr std::size_t kCounts[] = {1, 3, 3, 2, 2};
  const Vector3d v = geometry::dimensionsOf(s.shape);
  py::tuple out(kCounts[s.shape.index()]);
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = v[static_cast<Eigen::Index>(i)];
  return out;
}

std::string describeShape(const ShapeBody& s) {
  return "abstand." + std::string(geometry::shapeName(s.shape)) +
         std::string(py::str(py::repr(dimensionsOf(s))));
}

void bindShapes(py::module_& module) {
  py::class_<ShapeBody>(module, "Shape", R"doc(An exact shape, centred on its own frame.

Made by sphere, ellipsoid, cuboid (box), cylinder and capsule; metres. Constant.)doc")
      .def_property_readonly(
          "name", [](const ShapeBody& s) { return std::string(geometry::shapeName(s.shape)); },
          "'sphere', 'ellipsoid', 'cuboid', 'cylinder' or 'capsule'.")
      .def_property_readonly("dimensions", &dimensionsOf, "The numbers (m) that it was made from, a tuple.")
      .def_property_readonly(
          "area", [](const ShapeBody& s) { return geometry::surfaceArea(s.shape); }, "m^2.")
      .def_property_readonly(
          "volume", [](const ShapeBody& s) { return geometry::massProperties(s.shape).volume; }, "m^3.")
      .def(
          "mesh",
          [](const ShapeBody& s, double sagitta) {
            Mesh out{geometry::tessellate(s.shape, sagitta), {}};
            out.report = mesh_file::inspect(out.mesh);
            return out;
          },
          py::arg("sagitta") = 0.001, py::call_guard<py::gil_scoped_release>(),
          R"doc(A closed Mesh with vertices on the surface.

No point of the shape is farther than `sagitta` (m) from it. UsageError where that takes too many triangles.)doc")
      .def("__repr__", &describeShape);

  using namespace geometry;
  module.def(
      "sphere", [](double radius) { return valid(Sphere{radius}); }, py::arg("radius"),
      "A sphere of `radius` (m).");
  module.def(
      "ellipsoid", [](double a, double b, double c) { return valid(Ellipsoid{Vector3d(a, b, c)}); },
      py::arg("a"), py::arg("b"), py::arg("c"), "An ellipsoid with the semi-axes a, b, c (m) along x, y, z.");
  for (const char* name : {"cuboid", "box"})
    module.def(
        name, [](double x, double y, double z) { return valid(Cuboid{Vector3d(x, y, z)}); }, py::arg("x"),
        py::arg("y"), py::arg("z"), "A cuboid with the full edge lengths x, y, z (m).");
  module.def(
      "cylinder",
      [](double radius, double length) {
        return valid(Cylinder{radius, length});
      },
      py::arg("radius"), py::arg("length"), "A cylinder along z, `length` (m) from cap to cap.");
  module.def(
      "capsule",
      [](double radius, double length) {
        return valid(Capsule{radius, length});
      },
      py::arg("radius"), py::arg("length"),
      "A capsule along z; `length` (m) is that of the cylindrical part, so length + 2 radius in all.");
}

}  // namespace

void bindMeshes(py::module_& module) {
  bindShapes(module);
  py::class_<Mesh>(module, "Mesh", R"doc(Triangles over shared vertices, metres, in the body's own frame.

Mesh(vertices, triangles) takes arrays (n, 3) of metres and (m, 3) of indices, counter-clockwise seen from outside. Vertices
within a millionth of the diagonal are merged. UsageError names the row that is not finite or out of range. Constant.)doc")
      .def(py::init(&meshOf), py::arg("vertices"), py::arg("triangles"))
      .def_property_readonly("vertices", &verticesOf, "(n, 3) float64, m; a read-only view without a copy.")
      .def_property_readonly("triangles", &trianglesOf,
                             "(m, 3) uint32, indices of vertices; a read-only view without a copy.")
      .def_property_readonly(
          "watertight", [](const Mesh& m) { return m.report.watertight; },
          "Closed and consistently oriented, so that inside and outside are certain.")
      .def_property_readonly(
          "volume", [](const Mesh& m) { return m.report.volume; },
          "m^3; negative where the mesh is inside out.")
      .def_property_readonly(
          "area", [](const Mesh& m) { return geometry::surfaceArea(m.mesh); }, "m^2.")
      .def_property_readonly(
          "extent", [](const Mesh& m) { return vectorArray(m.report.extent); }, "(3,), m, along x, y, z.")
      .def_property_readonly(
          "remarks", [](const Mesh& m) { return m.report.remarks; },
          "What is odd about it: open edges, doubts about the unit. A list of sentences.")
      .def(
          "save", [](const Mesh& m, const std::filesystem::path& path) { mesh_file::saveMesh(m.mesh, path); },
          py::arg("path"), py::call_guard<py::gil_scoped_release>(),
          "Writes binary STL or OBJ by the extension, metres. STL has single precision. UsageError, "
          "WriteError.")
      .def("__repr__", [](const Mesh& m) {
        return "<abstand.Mesh of " + std::to_string(m.mesh.vertices.size()) + " vertices and " +
               std::to_string(m.mesh.triangles.size()) + " triangles>";
      });
  module.def(
      "load_mesh",
      [](const std::filesystem::path& path, double scale) {
        auto loaded = mesh_file::loadMesh(path, scale);
        return Mesh{std::move(loaded.mesh), std::move(loaded.report)};
      },
      py::arg("path"), py::arg("scale") = 1.0, py::call_guard<py::gil_scoped_release>(),
      R"doc(Reads STL, OBJ, PLY, OFF and DAE, and what else assimp knows, by the extension.

Coordinates times `scale` are metres (0.001 for millimetres). Vertices are welded, degenerate triangles dropped, a closed mesh
that is inside out is turned; `remarks` of the Mesh say so. ParseError for what is no mesh, UsageError for a scale that is not
positive.)doc");
}

}  // namespace abstand::python
