// Any bytes as a mesh file: a clean mesh or a ParseError, nothing else.
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "core/base/error.hpp"
#include "core/geometry/mass_properties.hpp"
#include "core/mesh_file/mesh_file.hpp"

namespace {

void checkClean(const abstand::mesh_file::LoadedMesh& loaded) {
  const auto& mesh = loaded.mesh;
  ABSTAND_CHECK(!mesh.triangles.empty());
  ABSTAND_CHECK(loaded.report.triangles == mesh.triangles.size());
  for (const auto& v : mesh.vertices) ABSTAND_CHECK(v.allFinite());
  for (const auto& t : mesh.triangles) {
    for (const auto v : t) ABSTAND_CHECK(v < mesh.vertices.size());
    ABSTAND_CHECK(t[0] != t[1] && t[1] != t[2] && t[2] != t[0]);
  }
  ABSTAND_CHECK(abstand::geometry::surfaceArea(mesh) > 0.0);
  const auto m = abstand::geometry::massProperties(mesh);
  ABSTAND_CHECK(std::isfinite(m.volume) && m.com.allFinite() && m.inertia.allFinite());
  ABSTAND_CHECK(!loaded.report.watertight || loaded.report.volume > 0.0);
}

}  // namespace

/// The first byte chooses the format: s(tl), o(bj), p(ly), f (OFF) or d(ae).
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const char* format = "stl";
  if (data[0] == 'o') format = "obj";
  if (data[0] == 'p') format = "ply";
  if (data[0] == 'f') format = "off";
  if (data[0] == 'd') format = "dae";
  try {
    checkClean(
        abstand::mesh_file::parseMesh({reinterpret_cast<const char*>(data + 1), size - 1}, format, "fuzz"));
  } catch (const abstand::ParseError&) {
  }
  return 0;
}
