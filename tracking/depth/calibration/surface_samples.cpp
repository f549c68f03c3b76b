// Uniform samples of known surfaces.
#include "tracking/depth/calibration/surface_samples.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/random.hpp"

namespace abstand::tracking {
namespace {

constexpr double kSagitta = 1e-3;  // m, for meshes of shapes

struct Face {
  std::array<Vector3d, 3> corners;
  std::size_t body;
};

Vector3d doubleArea(const Face& f) {
  return (f.corners[1] - f.corners[0]).cross(f.corners[2] - f.corners[0]);
}

}  // namespace

std::vector<SurfaceSample> sampleSurfaces(std::span<const geometry::Surface* const> bodies, std::size_t count,
                                          std::uint64_t seed) {
  std::vector<Face> faces;
  std::vector<double> up_to;  // cumulative area of the faces
  double area = 0.0;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const geometry::TriangleMesh mesh = bodies[b]->mesh(kSagitta);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const Face face{{mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)}, b};
      if (!(doubleArea(face).norm() > 0.0)) continue;
      faces.push_back(face);
      up_to.push_back(area += doubleArea(face).norm());
    }
  }
  std::vector<SurfaceSample> samples;
  Random random(seed, 0);
  for (std::size_t i = 0; !faces.empty() && i < count; ++i) {
    const double at = (static_cast<double>(i) + random.unit()) / static_cast<double>(count) * area;
    const auto found = std::upper_bound(up_to.begin(), up_to.end(), at);
    const Face& f = faces[std::min(static_cast<std::size_t>(found - up_to.begin()), faces.size() - 1)];
    // Uniform in a triangle (Turk, Graphics Gems 1990).
    const double a = std::sqrt(random.unit()), b = random.unit();
    samples.push_back({(1.0 - a) * f.corners[0] + a * (1.0 - b) * f.corners[1] + a * b * f.corners[2],
                       doubleArea(f).normalized(), f.body});
  }
  return samples;
}

}  // namespace abstand::tracking
