// Meshes for the made-up scene.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/geometry/triangle_mesh.hpp"

namespace abstand::ui {

/// Superellipsoid about the origin: exponent 1 an ellipsoid, towards 0 a box with rounded edges.
inline geometry::TriangleMesh roundedBody(const Vector3d& half, double exponent, int rings = 16,
                                          int sectors = 28) {
  geometry::TriangleMesh mesh;
  const auto power = [exponent](double v) { return std::copysign(std::pow(std::abs(v), exponent), v); };
  for (int r = 0; r <= rings; ++r) {
    const double latitude = kPi * (static_cast<double>(r) / rings - 0.5);
    for (int s = 0; s < sectors; ++s) {
      const double longitude = 2.0 * kPi * s / sectors;
      const double c = r == 0 || r == rings ? 0.0 : power(std::cos(latitude));
      mesh.vertices.emplace_back(half.x() * c * power(std::cos(longitude)),
                                 half.y() * c * power(std::sin(longitude)),
                                 half.z() * power(std::sin(latitude)));
    }
  }
  for (int r = 0; r < rings; ++r)
    for (int s = 0; s < sectors; ++s) {
      const auto at = [&](int ring, int sector) {
        return static_cast<std::uint32_t>(ring * sectors + sector % sectors);
      };
      if (r > 0) mesh.triangles.push_back({at(r, s), at(r, s + 1), at(r + 1, s + 1)});
      if (r + 1 < rings) mesh.triangles.push_back({at(r, s), at(r + 1, s + 1), at(r + 1, s)});
    }
  return mesh;
}

inline geometry::TriangleMesh box(const Vector3d& half) {
  geometry::TriangleMesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.vertices.emplace_back(i & 1 ? half.x() : -half.x(), i & 2 ? half.y() : -half.y(),
                               i & 4 ? half.z() : -half.z());
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

}  // namespace abstand::ui
