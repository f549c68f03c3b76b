#include "core/mesh_file/coloured_ply.hpp"

#include <bit>

#include "core/base/output_file.hpp"

namespace abstand::mesh_file {
namespace {

void putWord(std::string& out, std::uint32_t word) {
  for (int shift = 0; shift < 32; shift += 8) out += static_cast<char>((word >> shift) & 0xff);
}
void putFloat(std::string& out, double value) {
  putWord(out, std::bit_cast<std::uint32_t>(static_cast<float>(value)));
}

std::string headerOf(const ColouredMesh& mesh) {
  std::string header = "ply\nformat binary_little_endian 1.0\n";
  for (const std::string& comment : mesh.comments) header += "comment " + comment + "\n";
  header += "element vertex " + std::to_string(mesh.mesh.vertices.size()) +
            "\nproperty float x\nproperty float y\nproperty float z\n"
            "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  for (const std::string& name : mesh.names) header += "property float " + name + "\n";
  return header + "element face " + std::to_string(mesh.mesh.triangles.size()) +
         "\nproperty list uchar uint vertex_indices\nend_header\n";
}

}  // namespace

void ColouredMesh::addQuad(const std::array<Vector3d, 4>& corners, const Rgb& colour,
                           const std::vector<double>& of_vertex) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (const Vector3d& corner : corners) {
    mesh.vertices.push_back(corner);
    colours.push_back(colour);
    values.insert(values.end(), of_vertex.begin(), of_vertex.end());
  }
  mesh.triangles.push_back({first, first + 1, first + 2});
  mesh.triangles.push_back({first, first + 2, first + 3});
}

void savePly(const ColouredMesh& mesh, const std::filesystem::path& file) {
  std::string out = headerOf(mesh);
  const std::size_t width = mesh.names.size();
  for (std::size_t v = 0; v < mesh.mesh.vertices.size(); ++v) {
    for (int i = 0; i < 3; ++i) putFloat(out, mesh.mesh.vertices[v][i]);
    for (const std::uint8_t c : mesh.colours[v]) out += static_cast<char>(c);
    for (std::size_t i = 0; i < width; ++i) putFloat(out, mesh.values[v * width + i]);
  }
  for (const auto& triangle : mesh.mesh.triangles) {
    out += '\3';
    for (const std::uint32_t corner : triangle) putWord(out, corner);
  }
  writeFile(file, out);
}

}  // namespace abstand::mesh_file
