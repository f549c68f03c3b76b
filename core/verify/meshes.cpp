// Meshes of bodies used by checks.
#include "core/verify/meshes.hpp"

#include <cmath>

#include "core/base/error.hpp"

namespace abstand::verify {
namespace {

using Point = std::pair<double, double>;

double turn(const Point& a, const Point& b, const Point& c) {
  return (b.first - a.first) * (c.second - a.second) - (b.second - a.second) * (c.first - a.first);
}

/// Triangulates by ear clipping.
std::vector<std::array<std::uint32_t, 3>> ears(const std::vector<Point>& polygon) {
  std::vector<std::uint32_t> left(polygon.size());
  for (std::uint32_t i = 0; i < left.size(); ++i) left[i] = i;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  while (left.size() >= 3) {
    const std::size_t before = left.size();
    for (std::size_t i = 0; i < left.size(); ++i) {
      const std::uint32_t a = left[(i + left.size() - 1) % left.size()], b = left[i],
                          c = left[(i + 1) % left.size()];
      if (turn(polygon[a], polygon[b], polygon[c]) <= 0.0) continue;
      bool empty = true;
      for (const std::uint32_t p : left) {
        if (p == a || p == b || p == c) continue;
        empty = empty && !(turn(polygon[a], polygon[b], polygon[p]) >= 0.0 &&
                           turn(polygon[b], polygon[c], polygon[p]) >= 0.0 &&
                           turn(polygon[c], polygon[a], polygon[p]) >= 0.0);
      }
      if (!empty) continue;
      triangles.push_back({a, b, c});
      left.erase(left.begin() + static_cast<std::ptrdiff_t>(i));
      break;
    }
    ABSTAND_CHECK(left.size() < before);
  }
  return triangles;
}

}  // namespace

geometry::TriangleMesh boxMesh(const Vector3d& size, const Vector3d& centre) {
  const double x = 0.5 * size.x(), y = 0.5 * size.y();
  geometry::TriangleMesh mesh = prismMesh({{-x, -y}, {x, -y}, {x, y}, {-x, y}}, size.z());
  for (Vector3d& v : mesh.vertices) v += centre;
  return mesh;
}

geometry::TriangleMesh prismMesh(const std::vector<Point>& polygon, double height) {
  geometry::TriangleMesh mesh;
  const auto n = static_cast<std::uint32_t>(polygon.size());
  for (const double z : {-0.5 * height, 0.5 * height})
    for (const Point& p : polygon) mesh.vertices.emplace_back(p.first, p.second, z);
  for (const auto& [a, b, c] : ears(polygon)) {
    mesh.triangles.push_back({a, c, b});
    mesh.triangles.push_back({a + n, b + n, c + n});
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    mesh.triangles.push_back({i, j, j + n});
    mesh.triangles.push_back({i, j + n, i + n});
  }
  return mesh;
}

geometry::TriangleMesh spikeMesh(double base, double height) {
  const double r = 0.5 * base;
  geometry::TriangleMesh mesh;
  mesh.vertices = {{-r, -r, 0}, {r, -r, 0}, {r, r, 0}, {-r, r, 0}, {0, 0, height}};
  mesh.triangles = {{0, 2, 1}, {0, 3, 2}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  return mesh;
}

geometry::TriangleMesh starMesh(double inner, double outer) {
  const double g = 0.5 * (1.0 + std::sqrt(5.0));
  const std::vector<Vector3d> corners{{-1, g, 0}, {1, g, 0}, {-1, -g, 0}, {1, -g, 0},
                                      {0, -1, g}, {0, 1, g}, {0, -1, -g}, {0, 1, -g},
                                      {g, 0, -1}, {g, 0, 1}, {-g, 0, -1}, {-g, 0, 1}};
  geometry::TriangleMesh mesh;
  for (const Vector3d& c : corners) mesh.vertices.push_back(inner * c.normalized());
  // Faces: three corners that are mutual nearest neighbours, 2 apart before scaling.
  const auto near = [&](std::uint32_t i, std::uint32_t j) { return (corners[i] - corners[j]).norm() < 2.1; };
  for (std::uint32_t i = 0; i < 12; ++i) {
    for (std::uint32_t j = i + 1; j < 12; ++j) {
      for (std::uint32_t k = j + 1; k < 12; ++k) {
        if (!near(i, j) || !near(j, k) || !near(k, i)) continue;
        const Vector3d middle = corners[i] + corners[j] + corners[k];
        const bool outwards = (corners[j] - corners[i]).cross(corners[k] - corners[i]).dot(middle) > 0.0;
        const std::uint32_t a = i, b = outwards ? j : k, c = outwards ? k : j;
        const auto tip = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.vertices.push_back(outer * middle.normalized());
        for (const auto& [p, q] : {Point(a, b), Point(b, c), Point(c, a)})
          mesh.triangles.push_back({static_cast<std::uint32_t>(p), static_cast<std::uint32_t>(q), tip});
      }
    }
  }
  return mesh;
}

geometry::TriangleMesh torusMesh(double ring, double tube, int around, int across) {
  std::vector<Point> profile;
  for (int j = 0; j < across; ++j) {
    const double b = 2.0 * kPi * j / across;
    profile.emplace_back(ring + tube * std::cos(b), tube * std::sin(b));
  }
  return latheMesh(profile, around);
}

geometry::TriangleMesh latheMesh(const std::vector<Point>& profile, int around) {
  const auto across = static_cast<int>(profile.size());
  geometry::TriangleMesh mesh;
  for (int i = 0; i < around; ++i) {
    const double a = 2.0 * kPi * i / around;
    for (const auto& [r, z] : profile) mesh.vertices.emplace_back(r * std::cos(a), r * std::sin(a), z);
  }
  const auto at = [&](int i, int j) {
    return static_cast<std::uint32_t>((i % around) * across + j % across);
  };
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return mesh;
}

geometry::TriangleMesh foldedSheet(double size) {
  const double r = 0.5 * size;
  geometry::TriangleMesh mesh;
  mesh.vertices = {{-r, -r, 0}, {0, -r, 0}, {0, r, 0}, {-r, r, 0}, {r, -r, r}, {r, r, r}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {1, 4, 5}, {1, 5, 2}};
  return mesh;
}

geometry::TriangleMesh inverted(geometry::TriangleMesh mesh) {
  for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

geometry::TriangleMesh together(const geometry::TriangleMesh& a, const geometry::TriangleMesh& b) {
  geometry::TriangleMesh mesh = a;
  const auto first = static_cast<std::uint32_t>(a.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (const auto& t : b.triangles) mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  return mesh;
}

}  // namespace abstand::verify
