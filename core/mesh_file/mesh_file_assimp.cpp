// The only file that includes assimp.
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cstring>

#include "core/mesh_file/mesh_file_child.hpp"
#include "core/mesh_file/mesh_file_readers.hpp"

namespace abstand::mesh_file {
namespace {

// More vertices than this after instancing are rejected.
constexpr std::size_t kMaxVertices = 60'000'000;
constexpr int kMaxDepth = 256;
// Upper bound for a valid file of 512 MiB.
constexpr unsigned kMaxSeconds = 20;
constexpr std::size_t kMaxMemory = std::size_t{8} << 30;

Eigen::Matrix4d toEigen(const aiMatrix4x4& m) {
  Eigen::Matrix4d out;
  out << m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4, m.d1, m.d2, m.d3, m.d4;
  return out;
}

/// Collects the triangles of a node and its descendants.
class Collector {
 public:
  Collector(const aiScene& scene, const std::string& name) : scene_(scene), name_(name) {}

  void visit(const aiNode& node, const Eigen::Matrix4d& parent, int depth) {
    if (depth > kMaxDepth) throw ParseError({name_}, "found nodes nested too deep for a mesh");
    const Eigen::Matrix4d X = parent * toEigen(node.mTransformation);
    for (unsigned m = 0; m < node.mNumMeshes; ++m) add(*scene_.mMeshes[node.mMeshes[m]], X);
    for (unsigned c = 0; c < node.mNumChildren; ++c) visit(*node.mChildren[c], X, depth + 1);
  }
  geometry::TriangleMesh take() { return std::move(mesh_); }

 private:
  void add(const aiMesh& mesh, const Eigen::Matrix4d& X) {
    const bool mirrored = X.topLeftCorner<3, 3>().determinant() < 0.0;
    const auto first = static_cast<std::uint32_t>(mesh_.vertices.size());
    if (mesh_.vertices.size() + mesh.mNumVertices > kMaxVertices)
      throw ParseError({name_}, "found more vertices than a mesh of a body can have");
    for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
      const Eigen::Vector4d p(mesh.mVertices[v].x, mesh.mVertices[v].y, mesh.mVertices[v].z, 1.0);
      mesh_.vertices.push_back((X * p).head<3>());
      if (!mesh_.vertices.back().allFinite())
        throw ParseError({name_}, "found a vertex that is not finite, expected numbers");
    }
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const aiFace& face = mesh.mFaces[f];
      if (face.mNumIndices != 3) continue;
      std::array<std::uint32_t, 3> t{};
      for (int i = 0; i < 3; ++i) {
        if (face.mIndices[i] >= mesh.mNumVertices)
          throw ParseError({name_}, "found a triangle whose vertex is not there");
        t[i] = first + face.mIndices[i];
      }
      if (mirrored) std::swap(t[1], t[2]);
      mesh_.triangles.push_back(t);
    }
  }

  const aiScene& scene_;
  const std::string& name_;
  geometry::TriangleMesh mesh_;
};

geometry::TriangleMesh readHere(std::string_view content, std::string_view format, const std::string& name) {
  Assimp::Importer importer;
  importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
  const aiScene* scene =
      importer.ReadFileFromMemory(content.data(), content.size(),
                                  aiProcess_Triangulate | aiProcess_SortByPType, std::string(format).c_str());
  if (!scene || !scene->mRootNode) {
    std::string why = importer.GetErrorString();
    std::replace(why.begin(), why.end(), '\n', ' ');
    throw ParseError({name}, "cannot be read as " + std::string(format) + ": " + why.substr(0, 200));
  }
  Collector collector(*scene, name);
  collector.visit(*scene->mRootNode, Eigen::Matrix4d::Identity(), 0);
  return collector.take();
}

// Answer of the child: 'E' and an error text, or 'M', the two counts, and the arrays as in memory.

template <class T>
void append(std::string& bytes, const T* data, std::size_t count) {
  bytes.append(reinterpret_cast<const char*>(data), count * sizeof(T));
}

std::string packed(const geometry::TriangleMesh& mesh) {
  std::string bytes = "M";
  const std::size_t counts[2] = {mesh.vertices.size(), mesh.triangles.size()};
  append(bytes, counts, 2);
  append(bytes, mesh.vertices.data(), counts[0]);
  append(bytes, mesh.triangles.data(), counts[1]);
  return bytes;
}

geometry::TriangleMesh unpacked(const std::string& bytes) {
  std::size_t counts[2];
  std::memcpy(counts, bytes.data() + 1, sizeof counts);
  geometry::TriangleMesh mesh;
  mesh.vertices.resize(counts[0]);
  mesh.triangles.resize(counts[1]);
  const char* at = bytes.data() + 1 + sizeof counts;
  const std::size_t vertex_bytes = counts[0] * sizeof(Vector3d),
                    triangle_bytes = counts[1] * sizeof(mesh.triangles[0]);
  ABSTAND_CHECK(bytes.size() == 1 + sizeof counts + vertex_bytes + triangle_bytes);
  if (counts[0] > 0) std::memcpy(static_cast<void*>(mesh.vertices.data()), at, vertex_bytes);
  if (counts[1] > 0) std::memcpy(mesh.triangles.data(), at + vertex_bytes, triangle_bytes);
  return mesh;
}

}  // namespace

geometry::TriangleMesh readWithAssimp(std::string_view content, std::string_view format,
                                      const std::string& name) {
  const ChildAnswer answer = runInChild(
      [&] {
        try {
          return packed(readHere(content, format, name));
        } catch (const ParseError& e) {
          return std::string("E") + e.message();
        } catch (const std::exception& e) {
          return std::string("Ecannot be read as ") + std::string(format) + ": " + e.what();
        }
      },
      kMaxSeconds, kMaxMemory);
  if (!answer.finished)
    throw ParseError({name},
                     "the mesh library gave up on it" +
                         (answer.signal ? " (signal " + std::to_string(answer.signal) + ")" : std::string()) +
                         ", expected a sound " + std::string(format) + " file");
  if (answer.bytes[0] == 'E') throw ParseError({name}, answer.bytes.substr(1));
  return unpacked(answer.bytes);
}

}  // namespace abstand::mesh_file
