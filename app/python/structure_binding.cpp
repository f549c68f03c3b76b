// abstand.Structure.
#include <pybind11/stl/filesystem.h>

#include "app/python/array_view.hpp"
#include "app/python/bodies.hpp"
#include "app/python/interrupt_check.hpp"
#include "core/base/error.hpp"
#include "core/store/structure_cache.hpp"
#include "core/store/structure_file.hpp"

namespace abstand::python {
namespace {

struct BuildArguments {
  structure::HapticOptions options;
  std::string name;
  int threads;
  bool cache;
};

structure::HapticOptions optionsOf(double voxel, std::optional<double> spacing, int outer_layers,
                                   const std::string& field) {
  const auto kind = structure::parseFieldKind(field);
  if (!kind) throw UsageError("field: found '" + field + "', expected mixed, float or layered");
  structure::HapticOptions options{voxel, spacing.value_or(voxel), outer_layers, *kind};
  options.validate();
  return options;
}

Structure build(const std::shared_ptr<const geometry::Surface>& surface, const BuildArguments& args) {
  if (args.threads < 0)
    throw UsageError("threads: found " + std::to_string(args.threads) + ", expected 0 or more");
  store::StructureCache cache(args.cache ? store::userCacheFolder() : std::filesystem::path());
  std::shared_ptr<const structure::HapticStructure> made;
  buildInterruptibly([&](const structure::BuildMonitor& monitor) {
    made =
        store::makeHapticStructure(cache, args.name, surface, args.options, args.threads, monitor).structure;
  });
  return {std::move(made), {}, {}};
}

/// (n, 3) float32 from three vectors, created once.
py::object interleaved(py::object& kept, const std::vector<float>& x, const std::vector<float>& y,
                       const std::vector<float>& z) {
  if (kept) return kept;
  py::array_t<float> rows({static_cast<py::ssize_t>(x.size()), py::ssize_t{3}});
  float* out = rows.mutable_data();
  for (std::size_t i = 0; i < x.size(); ++i) {
    *out++ = x[i];
    *out++ = y[i];
    *out++ = z[i];
  }
  makeReadOnly(rows);
  return kept = rows;
}

std::string describeStructure(const Structure& s) {
  const std::string name = s.haptic->name.empty() ? "" : " '" + s.haptic->name + "'";
  return "<abstand.Structure" + name + " of " + std::to_string(s.haptic->shell.size()) + " points, " +
         std::to_string(s.haptic->memoryBytes() >> 10) + " KiB>";
}

void bindProperties(py::class_<Structure>& type) {
  type.def_property_readonly(
          "name", [](const Structure& s) { return s.haptic->name; }, "As it was given.")
      .def_property_readonly(
          "points",
          [](Structure& s) {
            const shell::Pointshell& shell = s.haptic->shell;
            return interleaved(s.points, shell.x, shell.y, shell.z);
          },
          "(n, 3) float32, m, read-only: the pointshell in the body's frame. Assembled once, then shared.")
      .def_property_readonly(
          "normals",
          [](Structure& s) {
            const shell::Pointshell& shell = s.haptic->shell;
            return interleaved(s.normals, shell.nx, shell.ny, shell.nz);
          },
          "(n, 3) float32, read-only: unit normals of the points; they point inwards.")
      .def_property_readonly(
          "areas",
          [](py::handle self) {
            const auto& area = py::cast<const Structure&>(self).haptic->shell.area;
            return viewOf(area.data(), {static_cast<py::ssize_t>(area.size())}, {sizeof(float)}, self);
          },
          "(n,) float32, m^2, the area that each point stands for; a read-only view without a copy.")
      .def_property_readonly(
          "memory", [](const Structure& s) { return s.haptic->memoryBytes(); }, "Bytes.")
      .def_property_readonly(
          "voxel", [](const Structure& s) { return s.haptic->options.voxel_size; }, "m, edge of a voxel.")
      .def_property_readonly(
          "spacing", [](const Structure& s) { return s.haptic->options.point_spacing; },
          "m, pitch of the points.")
      .def_property_readonly(
          "covering_radius", [](const Structure& s) { return s.haptic->shell.covering_radius; },
          "m: no point of the surface is farther than this from the nearest of `points`.")
      .def_property_readonly(
          "centre_of_mass", [](const Structure& s) { return vectorArray(s.haptic->com); },
          "(3,), m, body frame, for uniform density; torques are about it.")
      .def_property_readonly(
          "volume", [](const Structure& s) { return s.haptic->mass_properties.volume; },
          "m^3; 0 where the surface encloses none.")
      .def_property_readonly(
          "watertight", [](const Structure& s) { return s.haptic->surface->watertight(); },
          "Closed and consistently oriented, so that inside and outside are certain.")
      .def_property_readonly(
          "build_ms", [](const Structure& s) { return s.haptic->build_ms; }, "Build time, ms.");
}

constexpr const char* kStructureDoc =
    R"doc(Collision data of one body: distance fields and a pointshell, beside its exact surface.

Structure(body, voxel=0.005, spacing=None, outer_layers=20, field='mixed', name='', threads=0, cache=False)

body: a Mesh or a Shape. voxel: m, half of the smallest feature that matters. spacing: m, pitch of the points; None: `voxel`.
outer_layers: layers of voxels outside the surface. field: 'mixed', 'float' or 'layered'. threads: 0 is all cores; the result
does not depend on it. cache: look for it in the user's cache folder, and keep it there.

Constant: any number of threads may use one. Building releases the GIL; Ctrl-C ends it. UsageError for options that do not fit
the body.)doc";

}  // namespace

void bindStructures(py::module_& module) {
  py::class_<Structure> type(module, "Structure", kStructureDoc);
  const auto of_mesh = [](const Mesh& mesh, double voxel, std::optional<double> spacing, int outer_layers,
                          const std::string& field, std::string name, int threads, bool cache) {
    const BuildArguments args{optionsOf(voxel, spacing, outer_layers, field), std::move(name), threads,
                              cache};
    const py::gil_scoped_release release;
    return build(geometry::makeSurface(mesh.mesh), args);
  };
  const auto of_shape = [](const ShapeBody& shape, double voxel, std::optional<double> spacing,
                           int outer_layers, const std::string& field, std::string name, int threads,
                           bool cache) {
    const BuildArguments args{optionsOf(voxel, spacing, outer_layers, field), std::move(name), threads,
                              cache};
    const py::gil_scoped_release release;
    return build(geometry::makeSurface(shape.shape), args);
  };
  type.def(py::init(of_mesh), py::arg("body"), py::arg("voxel") = 0.005, py::arg("spacing") = py::none(),
           py::arg("outer_layers") = 20, py::arg("field") = "mixed", py::arg("name") = "",
           py::arg("threads") = 0, py::arg("cache") = false);
  type.def(py::init(of_shape), py::arg("body"), py::arg("voxel") = 0.005, py::arg("spacing") = py::none(),
           py::arg("outer_layers") = 20, py::arg("field") = "mixed", py::arg("name") = "",
           py::arg("threads") = 0, py::arg("cache") = false);
  type.def(
          "save",
          [](const Structure& s, const std::filesystem::path& path) {
            store::saveStructure(*s.haptic, path);
          },
          py::arg("path"), py::call_guard<py::gil_scoped_release>(),
          R"doc(Writes the structure with its surface to a file, completely or not at all. UsageError, WriteError.)doc")
      .def_static(
          "load",
          [](const std::filesystem::path& path, bool trusted) {
            store::StructureCache none{std::filesystem::path()};
            return Structure{store::loadStructure(path, trusted, none, 0), {}, {}};
          },
          py::arg("path"), py::arg("trusted") = false, py::call_guard<py::gil_scoped_release>(),
          R"doc(The structure that save() wrote, with the same bits (docs/structure-files.md).

It is built from the body and the resolution in the file, which are checked, so the file may be anybody's. With `trusted` what
the engine had in memory is taken as it stands, if this version of the engine wrote it: as fast as reading the file, for files of
your own programs. ParseError for a file that is none or damaged.)doc")
      .def("__repr__", &describeStructure);
  bindProperties(type);
}

}  // namespace abstand::python
