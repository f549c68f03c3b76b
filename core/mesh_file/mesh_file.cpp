// Reads a mesh file into a clean mesh, and writes meshes.
#include "core/mesh_file/mesh_file.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "core/base/error.hpp"
#include "core/base/number.hpp"
#include "core/base/output_file.hpp"
#include "core/base/text_file.hpp"
#include "core/geometry/mass_properties.hpp"
#include "core/mesh_file/mesh_file_clean.hpp"
#include "core/mesh_file/mesh_file_readers.hpp"

namespace abstand::mesh_file {
namespace {

constexpr std::uintmax_t kMaxBytes = std::uintmax_t{512} << 20;

/// Share of the diagonal within which vertices are equal: ten rounding steps of single precision.
constexpr double kSamePoint = 1e-6;

struct Format {
  std::string_view extension;
  geometry::TriangleMesh (*read)(std::string_view, const std::string&);
};
constexpr std::array<Format, 5> kFormats{
    {{"stl", readStl}, {"obj", readObj}, {"ply", readPly}, {"off", readOff}, {"dae", readDae}}};

std::string lower(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return out;
}

std::string extensionOf(const std::filesystem::path& file) {
  const std::string extension = lower(file.extension().string());
  return extension.empty() ? extension : extension.substr(1);
}

geometry::TriangleMesh readRaw(std::string_view content, std::string_view extension,
                               const std::string& name) {
  const std::string known = lower(extension);
  for (const auto& format : kFormats)
    if (format.extension == known) return format.read(content, name);
  if (known.empty())
    throw ParseError({name}, "found no extension, expected stl, obj, ply, off, dae or another mesh format");
  return readWithAssimp(content, known, name);
}

void writeStl(const geometry::TriangleMesh& mesh, std::ostream& out) {
  std::array<char, 80> header{};
  std::copy_n("binary STL of abstand, metres", 29, header.begin());
  out.write(header.data(), header.size());
  const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
  out.write(reinterpret_cast<const char*>(&count), sizeof count);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Vector3d& a = mesh.corner(t, 0);
    const Vector3d normal = (mesh.corner(t, 1) - a).cross(mesh.corner(t, 2) - a).normalized();
    const std::array<Vector3f, 4> record{normal.cast<float>(), a.cast<float>(),
                                         mesh.corner(t, 1).cast<float>(), mesh.corner(t, 2).cast<float>()};
    for (const auto& v : record) out.write(reinterpret_cast<const char*>(v.data()), 12);
    out.write("\0\0", 2);
  }
}

void writeObj(const geometry::TriangleMesh& mesh, std::ostream& out) {
  out << "# abstand, metres\n";
  for (const auto& v : mesh.vertices)
    out << "v " << formatDouble(v.x()) << ' ' << formatDouble(v.y()) << ' ' << formatDouble(v.z()) << '\n';
  for (const auto& t : mesh.triangles) out << "f " << t[0] + 1 << ' ' << t[1] + 1 << ' ' << t[2] + 1 << '\n';
}

}  // namespace

LoadedMesh parseMesh(std::string_view content, std::string_view format, const std::string& name,
                     double scale) {
  if (!std::isfinite(scale) || scale <= 0.0)
    throw UsageError("scale is " + formatDouble(scale) + ", expected a positive number of metres per unit");
  geometry::TriangleMesh raw = readRaw(content, format, name);
  if (raw.triangles.empty()) throw ParseError({name}, "found no triangle, expected a mesh");

  geometry::Bounds box;
  for (auto& v : raw.vertices) {
    v *= scale;
    if (!(v.cwiseAbs().maxCoeff() <= kFarthestVertex))
      throw ParseError({name},
                       "found a coordinate of " + formatDouble(v.cwiseAbs().maxCoeff()) +
                           " m, expected at most " + formatDouble(kFarthestVertex) + " m",
                       "scale: 0.001 if the file is in millimetres");
  }
  for (std::size_t t = 0; t < raw.triangles.size(); ++t)
    for (int i = 0; i < 3; ++i) box.add(raw.corner(t, i));
  const double tolerance = kSamePoint * box.extent().norm();

  auto cleaned = clean(raw, tolerance);
  if (cleaned.mesh.triangles.empty())
    throw ParseError({name}, "found degenerate triangles only, expected one with an area");
  LoadedMesh out{std::move(cleaned.mesh), {}};
  const MeshReport before = inspect(out.mesh);
  const bool inside_out = before.volume < 0.0 && before.open_edges == 0 && before.non_manifold_edges == 0 &&
                          before.flipped_edges == 0;
  if (inside_out)
    for (auto& t : out.mesh.triangles) std::swap(t[1], t[2]);
  out.report = inside_out ? inspect(out.mesh) : before;
  out.report.degenerate_triangles = cleaned.degenerate;
  if (inside_out) out.report.remarks.push_back("The mesh was inside out; its triangles were turned.");
  if (cleaned.degenerate > 0)
    out.report.remarks.push_back(
        std::to_string(cleaned.degenerate) +
        (cleaned.degenerate == 1 ? " degenerate triangle was" : " degenerate triangles were") + " dropped.");
  return out;
}

LoadedMesh loadMesh(const std::filesystem::path& file, double scale) {
  const std::string format = extensionOf(file);
  // A directory or a missing file is reported before a wrong extension.
  const std::string content = readFile(file, kMaxBytes);
  return parseMesh(content, format, file.string(), scale);
}

void saveMesh(const geometry::TriangleMesh& mesh, const std::filesystem::path& file) {
  const std::string format = extensionOf(file);
  if (format != "stl" && format != "obj")
    throw UsageError(file.string() + ": found the extension \"" + format + "\", expected stl or obj");
  OutputFile out(file);
  if (format == "stl")
    writeStl(mesh, out.stream());
  else
    writeObj(mesh, out.stream());
  out.commit();
}

}  // namespace abstand::mesh_file
