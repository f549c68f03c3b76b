#include "tests/support/bumpy_meshes.hpp"

#include <cmath>

#include "core/geometry/shape.hpp"
#include "core/math/random.hpp"
#include "core/verify/meshes.hpp"

namespace abstand::testing {

geometry::TriangleMesh bumpyTorus(double ring, double tube, int around, int across) {
  geometry::TriangleMesh mesh = verify::torusMesh(ring, tube, around, across);
  for (Vector3d& v : mesh.vertices) {
    const double a = std::atan2(v.y(), v.x());
    const Vector3d middle(ring * std::cos(a), ring * std::sin(a), 0.0);
    const Vector3d out = v - middle;
    const double b = std::atan2(out.z(), out.dot(middle) / ring);
    v = middle + out * (1.0 + 0.125 * std::sin(9.0 * a + 0.4) * std::cos(4.0 * b));
  }
  return mesh;
}

geometry::TriangleMesh bumpyBall(double radius, double sagitta) {
  constexpr int kWaves = 24;
  constexpr double kHeight = 0.3;  // of the radius, of a wave of frequency 1
  geometry::TriangleMesh mesh = geometry::tessellate(geometry::Sphere{radius}, sagitta);
  for (Vector3d& v : mesh.vertices) {
    const Vector3d out = v.normalized();
    double height = 0.0;
    for (int i = 0; i < kWaves; ++i) {
      Random random(7, static_cast<std::uint64_t>(i));
      const Vector3d along = random.direction();
      const double frequency = random.between(2.0, 14.0);
      height += kHeight / frequency * std::sin(frequency * along.dot(out) + random.between(0.0, 6.0));
    }
    v = radius * (1.0 + height) * out;
  }
  return mesh;
}

}  // namespace abstand::testing
