#include "core/geometry/mesh_file.hpp"

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cstring>

#include "core/base/error.hpp"
#include "core/base/number.hpp"
#include "core/base/output_file.hpp"
#include "core/base/text_file.hpp"
#include "core/geometry/mesh_memory.hpp"

namespace abstand {
namespace {

constexpr std::uintmax_t kMostBytes = std::uintmax_t{1} << 30;
// Vertices closer than this part of the extent are one.
constexpr double kWeldTolerance = 1e-7;
constexpr double kMostExtent = 1e9;

std::string extensionOf(const std::filesystem::path& file) {
  std::string e = file.extension().string();
  if (!e.empty()) e.erase(0, 1);
  std::transform(e.begin(), e.end(), e.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return e;
}

/// A binary STL says how many triangles follow; a header that claims more than there are bytes is a lie that
/// no library needs to see.
void refuseFalseStlClaim(const std::string& bytes, const std::string& name) {
  constexpr std::size_t kHeader = 84, kTriangle = 50;
  if (bytes.size() < kHeader || bytes.compare(0, 5, "solid") == 0) return;
  std::uint32_t claimed = 0;
  std::memcpy(&claimed, bytes.data() + 80, sizeof claimed);
  if (claimed > (bytes.size() - kHeader) / kTriangle)
    throw ParseError({name}, "the header claims " + std::to_string(claimed) +
                                 " triangles, the file holds at most " +
                                 std::to_string((bytes.size() - kHeader) / kTriangle));
}

/// The header of a PLY file likewise: an element takes at least a byte, ascii or binary.
void refuseFalsePlyClaim(const std::string& bytes, const std::string& name) {
  if (bytes.compare(0, 3, "ply") != 0) return;
  const std::size_t end = std::min(bytes.find("end_header"), bytes.size());
  int line = 0;
  for (std::size_t at = 0; at < end; ++line) {
    const std::size_t stop = std::min(bytes.find('\n', at), end);
    const std::string text = bytes.substr(at, stop - at);
    if (text.compare(0, 8, "element ") == 0) {
      const std::size_t blank = text.find(' ', 8);
      std::string number = blank == std::string::npos ? "" : text.substr(blank + 1);
      while (!number.empty() && std::isspace(static_cast<unsigned char>(number.back()))) number.pop_back();
      const auto count = parseDouble(number);
      if (!count || *count < 0 || *count > static_cast<double>(bytes.size()))
        throw ParseError({name, line + 1},
                         "found a count of '" + number + "', expected at most as many as the file has bytes");
    }
    at = stop + 1;
  }
}

/// And an OFF file: the first three numbers after its word.
void refuseFalseOffClaim(const std::string& bytes, const std::string& name) {
  if (bytes.compare(0, 3, "OFF") != 0) return;
  std::size_t at = 3;
  for (int i = 0; i < 2; ++i) {
    while (at < bytes.size()) {
      if (bytes[at] == '#')
        at = std::min(bytes.find('\n', at), bytes.size());
      else if (std::isspace(static_cast<unsigned char>(bytes[at])))
        ++at;
      else
        break;
    }
    const std::size_t end = std::min(bytes.find_first_of(" \t\r\n", at), bytes.size());
    const auto count = parseDouble(std::string_view(bytes).substr(at, end - at));
    if (!count || *count < 0 || *count > static_cast<double>(bytes.size()))
      throw ParseError({name}, "found '" + bytes.substr(at, std::min<std::size_t>(end - at, 30)) +
                                   "', expected a count of vertices and of faces that the file can hold");
    at = end;
  }
}

Eigen::Matrix4d toEigen(const aiMatrix4x4& m) {
  Eigen::Matrix4d out;
  out << m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4, m.d1, m.d2, m.d3, m.d4;
  return out;
}

void collect(const aiScene& scene, const aiNode& node, const Eigen::Matrix4d& parent, double scale,
             TriangleMesh& out) {
  const Eigen::Matrix4d X = parent * toEigen(node.mTransformation);
  const bool mirrored = X.topLeftCorner<3, 3>().determinant() < 0.0;
  for (unsigned m = 0; m < node.mNumMeshes; ++m) {
    const aiMesh& mesh = *scene.mMeshes[node.mMeshes[m]];
    const auto first = static_cast<std::uint32_t>(out.vertices.size());
    for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
      const Eigen::Vector4d p(mesh.mVertices[v].x, mesh.mVertices[v].y, mesh.mVertices[v].z, 1.0);
      out.vertices.push_back(scale * (X * p).head<3>());
    }
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const aiFace& face = mesh.mFaces[f];
      if (face.mNumIndices != 3) continue;
      std::array<std::uint32_t, 3> t{first + face.mIndices[0], first + face.mIndices[1],
                                     first + face.mIndices[2]};
      if (mirrored) std::swap(t[1], t[2]);
      out.triangles.push_back(t);
    }
  }
  for (unsigned c = 0; c < node.mNumChildren; ++c) collect(scene, *node.mChildren[c], X, scale, out);
}

/// Drops triangles without an area; returns how many.
std::size_t dropDegenerate(TriangleMesh& mesh) {
  const auto before = mesh.triangles.size();
  std::erase_if(mesh.triangles, [&](const auto& t) {
    const Vector3d &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
    const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    return !((b - a).cross(c - a).norm() > 1e-12 * longest);
  });
  return before - mesh.triangles.size();
}

}  // namespace

LoadedMesh readMesh(const std::string& bytes, const std::string& extension, const std::string& name,
                    double scale) {
  if (!(scale > 0.0) || !std::isfinite(scale)) throw UsageError("scale: expected a positive number");
  if (extension == "stl") refuseFalseStlClaim(bytes, name);
  refuseFalsePlyClaim(bytes, name);
  refuseFalseOffClaim(bytes, name);
  Assimp::Importer importer;
  // Points and lines are no surface.
  importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  const aiScene* scene = nullptr;
  try {
    scene = importer.ReadFileFromMemory(bytes.data(), bytes.size(),
                                        aiProcess_Triangulate | aiProcess_SortByPType, extension.c_str());
  } catch (const std::exception& e) {
    throw ParseError({name}, std::string("cannot be read as a mesh: ") + e.what());
  }
  if (!scene || !scene->mRootNode) {
    std::string why = importer.GetErrorString();
    std::replace(why.begin(), why.end(), '\n', ' ');
    throw ParseError({name}, "cannot be read as a mesh: " + why.substr(0, 200));
  }
  TriangleMesh raw;
  collect(*scene, *scene->mRootNode, Eigen::Matrix4d::Identity(), scale, raw);
  for (const Vector3d& v : raw.vertices)
    if (!v.allFinite() || v.cwiseAbs().maxCoeff() > kMostExtent)
      throw ParseError({name},
                       "found a vertex that is not finite, expected coordinates in metres after scaling");
  if (raw.triangles.empty()) throw ParseError({name}, "found no triangle, expected a mesh");

  LoadedMesh loaded;
  loaded.mesh = weld(raw, kWeldTolerance * bounds(raw).extent().norm());
  dropDegenerate(loaded.mesh);
  if (loaded.mesh.triangles.empty())
    throw ParseError({name}, "found only triangles without an area, expected a mesh");
  loaded.report = inspect(loaded.mesh);
  if (loaded.report.volume < 0.0 && loaded.report.open_edges == 0 && loaded.report.flipped_edges == 0) {
    for (auto& t : loaded.mesh.triangles) std::swap(t[1], t[2]);
    loaded.report = inspect(loaded.mesh);
    loaded.report.remarks.push_back("the mesh was inside out and has been turned");
  }
  loaded.report.degenerate_triangles = raw.triangles.size() - loaded.mesh.triangles.size();
  if (loaded.report.degenerate_triangles > 0)
    loaded.report.remarks.push_back(std::to_string(loaded.report.degenerate_triangles) +
                                    " triangles without an area left out");
  return loaded;
}

LoadedMesh loadMesh(const std::filesystem::path& file, double scale) {
  return readMesh(readFile(file, kMostBytes), extensionOf(file), file.string(), scale);
}

void saveMesh(const TriangleMesh& mesh, const std::filesystem::path& file) {
  const std::string extension = extensionOf(file);
  if (extension != "stl" && extension != "obj")
    throw UsageError(file.string() + ": meshes are written as .stl or .obj");
  OutputFile out(file);
  auto& s = out.stream();
  if (extension == "obj") {
    for (const Vector3d& v : mesh.vertices)
      s << "v " << formatDouble(v.x()) << ' ' << formatDouble(v.y()) << ' ' << formatDouble(v.z()) << '\n';
    for (const auto& t : mesh.triangles) s << "f " << t[0] + 1 << ' ' << t[1] + 1 << ' ' << t[2] + 1 << '\n';
  } else {
    char header[80] = "binary STL, metres";
    s.write(header, sizeof header);
    const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
    s.write(reinterpret_cast<const char*>(&count), sizeof count);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const Vector3f n = (mesh.corner(t, 1) - mesh.corner(t, 0))
                             .cross(mesh.corner(t, 2) - mesh.corner(t, 0))
                             .normalized()
                             .cast<float>();
      s.write(reinterpret_cast<const char*>(n.data()), 12);
      for (int i = 0; i < 3; ++i) {
        const Vector3f v = mesh.corner(t, i).cast<float>();
        s.write(reinterpret_cast<const char*>(v.data()), 12);
      }
      s.write("\0\0", 2);
    }
  }
  out.commit();
}

}  // namespace abstand
