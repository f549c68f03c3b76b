#include "core/shell/half_space_overlap.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/error.hpp"

namespace abstand::shell {
namespace {

/// If the force is below this share of the sum of its magnitudes, the two sides of a sheet cancel and there
/// is no overlap.
constexpr double kSheet = 1e-3;

/// Integral of the positive depth over a triangle, divided by the triangle's area, times 6. `depth`: at the
/// corners, at least one of them positive.
double clippedDepth(const double (&depth)[3]) {
  if (depth[0] >= 0.0 && depth[1] >= 0.0 && depth[2] >= 0.0) return depth[0] + depth[1] + depth[2];
  // Corners of the clipped polygon in barycentric coordinates of the second and third corner.
  struct {
    double b, c, d;
  } polygon[4];
  constexpr double kB[3] = {0.0, 1.0, 0.0}, kC[3] = {0.0, 0.0, 1.0};
  int n = 0;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    if (depth[i] > 0.0) polygon[n++] = {kB[i], kC[i], depth[i]};
    if ((depth[i] > 0.0) != (depth[j] > 0.0)) {
      const double t = depth[i] / (depth[i] - depth[j]);
      polygon[n++] = {kB[i] + t * (kB[j] - kB[i]), kC[i] + t * (kC[j] - kC[i]), 0.0};
    }
  }
  double integral = 0.0;
  for (int k = 1; k + 1 < n; ++k) {
    const auto &p = polygon[0], &q = polygon[k], &r = polygon[k + 1];
    integral += ((q.b - p.b) * (r.c - p.c) - (q.c - p.c) * (r.b - p.b)) * (p.d + q.d + r.d);
  }
  return integral;
}

}  // namespace

void EllipsoidOverlap::forces(const Vector3d& u, std::span<const double> levels,
                              std::span<Vector3d> out) const {
  // Scaled to the unit ball, the half-space cuts off a cap of height t.
  const double half_height = semi_axes_.cwiseProduct(u).norm();
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const double t = std::clamp((levels[i] + half_height) / half_height, 0.0, 2.0);
    out[i] = semi_axes_.prod() * kPi / 3.0 * t * t * (3.0 - t) * u;
  }
}

MeshOverlap::MeshOverlap(geometry::TriangleMesh mesh)
    : mesh_(std::move(mesh)),
      vertices_below_([this] {
        std::vector<Vector3f> vertices;
        for (const Vector3d& v : mesh_.vertices) vertices.push_back(v.cast<float>());
        return PointsBelow(vertices);
      }()),
      first_(mesh_.vertices.size() + 1, 0) {
  for (const auto& t : mesh_.triangles) {
    for (const std::uint32_t v : t) ++first_[v + 1];
  }
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  list_.resize(first_.back());
  std::vector<std::uint32_t> next = first_;
  for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
    for (const std::uint32_t v : mesh_.triangles[t]) list_[next[v]++] = t;
  }
}

double MeshOverlap::lowest(const Vector3d& u) const {
  return double(vertices_below_.lowest(u.cast<float>()));
}

void MeshOverlap::forces(const Vector3d& u, std::span<const double> levels, std::span<Vector3d> out) const {
  ABSTAND_CHECK(!levels.empty() && out.size() == levels.size());
  // A triangle reaches into the half-space if one of its corners does. Vertices are found in float; a vertex
  // missed by rounding at the level contributes nothing.
  std::vector<std::uint32_t> reached, triangles;
  vertices_below_.find(u.cast<float>(), static_cast<float>(levels.back()), mesh_.vertices.size(), reached);
  for (const std::uint32_t v : reached)
    triangles.insert(triangles.end(), list_.begin() + first_[v], list_.begin() + first_[v + 1]);
  std::sort(triangles.begin(), triangles.end());
  triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
  std::vector<double> size(levels.size(), 0.0);
  std::fill(out.begin(), out.end(), Vector3d::Zero());
  for (const std::uint32_t t : triangles) {
    const Vector3d &a = mesh_.corner(t, 0), &b = mesh_.corner(t, 1), &c = mesh_.corner(t, 2);
    const Vector3d cross = (b - a).cross(c - a) / 6.0;
    const double height[3] = {u.dot(a), u.dot(b), u.dot(c)},
                 lowest_corner = std::min({height[0], height[1], height[2]});
    const double length = cross.norm();
    for (std::size_t d = levels.size(); d-- > 0 && levels[d] > lowest_corner;) {
      const double level = levels[d];
      const double pressed = clippedDepth({level - height[0], level - height[1], level - height[2]});
      out[d] -= pressed * cross;
      size[d] += pressed * length;
    }
  }
  for (std::size_t d = 0; d < levels.size(); ++d)
    if (!(out[d].norm() > kSheet * size[d])) out[d].setZero();
}

std::unique_ptr<HalfSpaceOverlap> halfSpaceOverlap(const geometry::Surface& surface, double sagitta) {
  if (const geometry::Shape* shape = surface.shape()) {
    if (const auto* ball = std::get_if<geometry::Sphere>(shape))
      return std::make_unique<EllipsoidOverlap>(Vector3d::Constant(ball->radius));
    if (const auto* ellipsoid = std::get_if<geometry::Ellipsoid>(shape))
      return std::make_unique<EllipsoidOverlap>(ellipsoid->semi_axes);
  }
  return std::make_unique<MeshOverlap>(surface.mesh(sagitta));
}

}  // namespace abstand::shell
