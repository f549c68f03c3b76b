// Closed triangle meshes of the shapes.
#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/error.hpp"
#include "core/base/number.hpp"
#include "core/geometry/shape.hpp"

namespace abstand::geometry {
namespace {

using Ring = std::vector<std::uint32_t>;

/// Smallest number of segments around a circumference.
constexpr int kRound = 32;

[[noreturn]] void tooFine(double sagitta) {
  throw UsageError("a tessellation within " + formatDouble(sagitta) + " m takes more than " +
                   std::to_string(kMaxTessellation) + " triangles, expected a coarser sagitta");
}

std::uint32_t addVertex(TriangleMesh& mesh, const Vector3d& p) {
  mesh.vertices.push_back(p);
  return static_cast<std::uint32_t>(mesh.vertices.size() - 1);
}

/// Sagitta of a mesh with vertices on the unit sphere: 1 minus the smallest distance of a triangle's plane
/// from the centre.
double unitSagitta(const TriangleMesh& mesh) {
  double smallest = 1.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Vector3d& a = mesh.corner(t, 0);
    const Vector3d normal = (mesh.corner(t, 1) - a).cross(mesh.corner(t, 2) - a).normalized();
    smallest = std::min(smallest, normal.dot(a));
  }
  return 1.0 - smallest;
}

/// The coarsest mesh make(m), m >= `n`, whose sagitta on the unit sphere is small enough. make(n) has
/// triangles(n) = per_square n^2 triangles.
template <class Make>
TriangleMesh refine(int n, double unit_sagitta, std::size_t per_square, const Make& make, double sagitta) {
  for (;;) {
    if (per_square * static_cast<std::size_t>(n) * static_cast<std::size_t>(n) > kMaxTessellation)
      tooFine(sagitta);
    TriangleMesh mesh = make(n);
    const double found = unitSagitta(mesh);
    if (found <= unit_sagitta) return mesh;
    // The sagitta is proportional to 1 / n^2.
    const double wanted =
        std::min(n * std::sqrt(found / unit_sagitta), static_cast<double>(kMaxTessellation));
    n = std::max(n + 1, static_cast<int>(wanted));
  }
}

/// Icosahedron on the unit sphere with each face divided into n^2 triangles.
TriangleMesh icosphere(int n) {
  const double g = 0.5 * (1.0 + std::sqrt(5.0));
  const std::array<Vector3d, 12> corners{{{-1, g, 0},
                                          {1, g, 0},
                                          {-1, -g, 0},
                                          {1, -g, 0},
                                          {0, -1, g},
                                          {0, 1, g},
                                          {0, -1, -g},
                                          {0, 1, -g},
                                          {g, 0, -1},
                                          {g, 0, 1},
                                          {-g, 0, -1},
                                          {-g, 0, 1}}};
  constexpr std::array<std::array<std::uint32_t, 3>, 20> kFaces{
      {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
       {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
       {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
  TriangleMesh mesh;
  for (const auto& c : corners) addVertex(mesh, c.normalized());

  // Vertices on an edge are shared by two faces; they run from the edge's lower vertex index to its higher
  // one.
  std::map<std::pair<std::uint32_t, std::uint32_t>, Ring> edges;
  const auto onEdge = [&](std::uint32_t from, std::uint32_t to, int k) {
    if (k == 0) return from;
    if (k == n) return to;
    const std::uint32_t low = std::min(from, to), high = std::max(from, to);
    auto& inner = edges[{low, high}];
    if (inner.empty()) {
      for (int i = 1; i < n; ++i)
        inner.push_back(addVertex(mesh, ((n - i) * corners[low] + i * corners[high]).normalized()));
    }
    return inner[static_cast<std::size_t>(from == low ? k : n - k) - 1];
  };
  for (const auto& [a, b, c] : kFaces) {
    Ring above{a};
    for (int row = 1; row <= n; ++row) {
      Ring below;
      for (int k = 0; k <= row; ++k) {
        if (k == 0)
          below.push_back(onEdge(a, b, row));
        else if (k == row)
          below.push_back(onEdge(a, c, row));
        else if (row == n)
          below.push_back(onEdge(b, c, k));
        else
          below.push_back(addVertex(
              mesh, ((n - row) * corners[a] + (row - k) * corners[b] + k * corners[c]).normalized()));
      }
      for (std::size_t k = 0; k + 1 < below.size(); ++k) {
        mesh.triangles.push_back({above[k], below[k], below[k + 1]});
        if (k + 1 < above.size()) mesh.triangles.push_back({above[k], below[k + 1], above[k + 1]});
      }
      above = std::move(below);
    }
  }
  return mesh;
}

TriangleMesh stretchedBall(const Vector3d& semi_axes, double sagitta) {
  // A radial gap on the unit sphere is scaled by at most the longest semi-axis.
  constexpr int kMinDivision = 6;  // a great circle then meets more than kRound triangles
  TriangleMesh mesh = refine(kMinDivision, sagitta / semi_axes.maxCoeff(), 20, icosphere, sagitta);
  for (auto& p : mesh.vertices) p = p.cwiseProduct(semi_axes);
  return mesh;
}

TriangleMesh box(const Vector3d& size) {
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i)
    addVertex(mesh, 0.5 * size.cwiseProduct(Vector3d(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1)));
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

/// Adds `count` vertices around the z axis, the first at angle 0 (+x).
Ring addRing(TriangleMesh& mesh, int count, double radius, double z) {
  Ring ring;
  for (int i = 0; i < count; ++i) {
    const double angle = 2.0 * kPi * i / count;
    ring.push_back(addVertex(mesh, {radius * std::cos(angle), radius * std::sin(angle), z}));
  }
  return ring;
}

/// Triangulates the band between two rings that both begin at angle 0. The triangles face outwards if `upper`
/// lies above or, in a plane seen from above, inside of `lower`. A ring of radius 0 is one vertex.
void stitch(TriangleMesh& mesh, const Ring& upper, const Ring& lower) {
  const std::size_t steps_up = upper.size() > 1 ? upper.size() : 0;
  const std::size_t steps_low = lower.size() > 1 ? lower.size() : 0;
  std::size_t i = 0, j = 0;
  while (i < steps_up || j < steps_low) {
    const auto u = upper[i % upper.size()], l = lower[j % lower.size()];
    // Advances on the ring whose next vertex comes first; on the lower one if both are at the same angle.
    if (i == steps_up || (j < steps_low && (j + 1) * steps_up <= (i + 1) * steps_low)) {
      ++j;
      mesh.triangles.push_back({u, l, lower[j % lower.size()]});
    } else {
      ++i;
      mesh.triangles.push_back({u, l, upper[i % upper.size()]});
    }
  }
}

/// stitch() with both rings reversed, for surfaces that face downwards.
void stitchDown(TriangleMesh& mesh, const Ring& lower, const Ring& upper) {
  const std::size_t first = mesh.triangles.size();
  stitch(mesh, lower, upper);
  for (std::size_t t = first; t < mesh.triangles.size(); ++t)
    std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
}

int countRound(double radius, double sagitta) {
  const double cosine = 1.0 - std::min(1.0, sagitta / radius);
  const double count = std::ceil(kPi / std::acos(cosine));
  if (!(count < static_cast<double>(kMaxTessellation))) tooFine(sagitta);
  return std::max(kRound, static_cast<int>(count));
}

/// Rings from z = half to -half, spaced by at most four times the distance of their vertices.
std::vector<Ring> addMiddle(TriangleMesh& mesh, int count, double radius, double half, double sagitta) {
  const double width = 2.0 * kPi * radius / count;
  const double wanted = std::ceil(2.0 * half / (4.0 * width));
  if (!(wanted * count * 2.0 < static_cast<double>(kMaxTessellation))) tooFine(sagitta);
  const int rows = half > 0.0 ? std::max(1, static_cast<int>(wanted)) : 0;
  std::vector<Ring> rings;
  for (int row = 0; row <= rows; ++row) {
    // The last height is -half exactly.
    const double z = rows > 0 ? half * (rows - 2 * row) / rows : 0.0;
    rings.push_back(addRing(mesh, count, radius, z));
    if (row > 0) stitch(mesh, rings[rings.size() - 2], rings.back());
  }
  return rings;
}

/// Flat cap of concentric rings whose vertex count halves inwards, so that triangles stay compact.
void addCap(TriangleMesh& mesh, const Ring& rim, double radius, double z) {
  const auto join = [&](const Ring& inner, const Ring& outer) {
    z > 0.0 ? stitch(mesh, inner, outer) : stitchDown(mesh, inner, outer);
  };
  Ring outer = rim;
  double r = radius;
  for (;;) {
    const double spacing = 2.0 * kPi * r / static_cast<double>(outer.size());
    const int count = static_cast<int>(outer.size() / 2);
    if (count < 6 || spacing >= 0.7 * r) break;
    r -= spacing;
    Ring inner = addRing(mesh, count, r, z);
    join(inner, outer);
    outer = std::move(inner);
  }
  join({addVertex(mesh, {0.0, 0.0, z})}, outer);
}

TriangleMesh tube(const Cylinder& s, double sagitta) {
  TriangleMesh mesh;
  const double half = 0.5 * s.length;
  const auto rings = addMiddle(mesh, countRound(s.radius, sagitta), s.radius, half, sagitta);
  addCap(mesh, rings.front(), s.radius, half);
  addCap(mesh, rings.back(), s.radius, -half);
  return mesh;
}

/// Hemisphere above the ring `equator` of 4 n vertices (below it for sign -1): ring j of n has 4 j vertices,
/// as on an octahedron.
void addDome(TriangleMesh& mesh, const Ring& equator, double radius, double z, double sign) {
  const auto join = [&](const Ring& inner, const Ring& outer) {
    sign > 0.0 ? stitch(mesh, inner, outer) : stitchDown(mesh, inner, outer);
  };
  const int n = static_cast<int>(equator.size() / 4);
  Ring inner{addVertex(mesh, {0.0, 0.0, z + sign * radius})};
  for (int j = 1; j <= n; ++j) {
    const double polar = 0.5 * kPi * j / n;
    Ring outer = j == n ? equator
                        : addRing(mesh, 4 * j, radius * std::sin(polar), z + sign * radius * std::cos(polar));
    join(inner, outer);
    inner = std::move(outer);
  }
}

TriangleMesh octahedralBall(int n) {
  TriangleMesh mesh;
  const Ring equator = addRing(mesh, 4 * n, 1.0, 0.0);
  addDome(mesh, equator, 1.0, 0.0, 1.0);
  addDome(mesh, equator, 1.0, 0.0, -1.0);
  return mesh;
}

TriangleMesh pill(const Capsule& s, double sagitta) {
  const TriangleMesh ball = refine(kRound / 4, sagitta / s.radius, 8, octahedralBall, sagitta);
  // The two domes are a sphere of 8 n^2 triangles; the middle part has less curvature.
  const int count =
      4 * static_cast<int>(std::lround(std::sqrt(static_cast<double>(ball.triangles.size()) / 8.0)));
  TriangleMesh mesh;
  const double half = 0.5 * s.length;
  const auto rings = addMiddle(mesh, count, s.radius, half, sagitta);
  addDome(mesh, rings.front(), s.radius, half, 1.0);
  addDome(mesh, rings.back(), s.radius, -half, -1.0);
  return mesh;
}

TriangleMesh make(const Sphere& s, double sagitta) {
  return stretchedBall(Vector3d::Constant(s.radius), sagitta);
}
TriangleMesh make(const Ellipsoid& s, double sagitta) { return stretchedBall(s.semi_axes, sagitta); }
TriangleMesh make(const Cuboid& s, double) { return box(s.size); }
TriangleMesh make(const Cylinder& s, double sagitta) { return tube(s, sagitta); }
TriangleMesh make(const Capsule& s, double sagitta) { return pill(s, sagitta); }

}  // namespace

TriangleMesh tessellate(const Shape& shape, double sagitta) {
  if (!(sagitta > 0.0) || !std::isfinite(sagitta))
    throw UsageError("sagitta is " + formatDouble(sagitta) + " m, expected a positive length");
  return std::visit([&](const auto& s) { return make(s, sagitta); }, shape);
}

}  // namespace abstand::geometry
