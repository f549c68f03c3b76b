// Connected pieces of a mesh.
#include "core/geometry/mesh_pieces.hpp"

#include <gtest/gtest.h>

#include "core/geometry/shape.hpp"

namespace abstand::geometry {
namespace mesh_pieces_test {

TEST(MeshPieces, HaveOnePointEach) {
  TriangleMesh mesh;
  for (int n = 0; n < 5; ++n) {
    EXPECT_EQ(pieces(mesh).size(), static_cast<std::size_t>(n));
    const TriangleMesh ball = tessellate(Sphere{0.1}, 0.01);
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const Vector3d& p : ball.vertices) mesh.vertices.push_back(p + n * Vector3d::UnitX());
    for (auto t : ball.triangles) mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  const std::vector<Vector3d> found = pieces(mesh);
  ASSERT_EQ(found.size(), 5u);
  for (int n = 0; n < 5; ++n)
    EXPECT_NEAR((found[static_cast<std::size_t>(n)] - n * Vector3d::UnitX()).norm(), 0.1, 1e-12);
}

}  // namespace mesh_pieces_test
}  // namespace abstand::geometry
