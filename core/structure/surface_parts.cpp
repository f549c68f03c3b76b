// Approximate convex decomposition of a body's surface.
#include "core/structure/surface_parts.hpp"

#include <algorithm>

namespace abstand::structure {
namespace {

// Share of the body's size: a part whose largest gap to its hull is below this is convex.
constexpr double kConvex = 2e-3;
// Share of the widest gap: gaps of mirrored parts differ by which of their triangles are sampled.
constexpr double kAboutEqual = 0.99;
// Triangles sampled to estimate the gap between a part and its hull: enough to choose the part to bisect.
constexpr std::size_t kLooks = 512;
// Share of the size; spheres are stored in float.
constexpr double kHullSphereRounding = 1e-6;

struct Part {
  std::vector<std::uint32_t> triangles;
  std::vector<Vector3d> corners;  ///< vertices of the hull
  double gap{0.0};                ///< m, between the hull and the planes of the triangles
};

Part makePart(const geometry::TriangleMesh& mesh, std::vector<std::uint32_t> triangles) {
  Part part;
  std::vector<std::uint32_t> used;
  used.reserve(3 * triangles.size());
  for (const std::uint32_t t : triangles)
    used.insert(used.end(), mesh.triangles[t].begin(), mesh.triangles[t].end());
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  part.corners.reserve(used.size());
  for (const std::uint32_t v : used) part.corners.push_back(mesh.vertices[v]);
  part.corners = hullCorners(part.corners);
  const std::size_t stride = (triangles.size() + kLooks - 1) / kLooks;
  for (std::size_t i = 0; i < triangles.size(); i += stride) {
    const Vector3d a = mesh.corner(triangles[i], 0);
    const Vector3d n =
        (mesh.corner(triangles[i], 1) - a).cross(mesh.corner(triangles[i], 2) - a).normalized();
    for (const Vector3d& corner : part.corners) part.gap = std::max(part.gap, n.dot(corner - a));
  }
  part.triangles = std::move(triangles);
  return part;
}

/// The part with the widest gap; of about equal ones, as in symmetric bodies, the largest.
Part& worstOf(std::vector<Part>& parts) {
  double widest = 0.0;
  for (const Part& part : parts) widest = std::max(widest, part.gap);
  return *std::max_element(parts.begin(), parts.end(), [&](const Part& l, const Part& r) {
    const auto size = [&](const Part& p) { return p.gap < kAboutEqual * widest ? 0 : p.triangles.size(); };
    return size(l) < size(r);
  });
}

/// Splits at the median of the triangles' centres, along the axis of their largest extent.
std::pair<Part, Part> halves(const geometry::TriangleMesh& mesh, Part& part) {
  const auto middle = [&](std::uint32_t t) {
    return Vector3d(mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2));
  };
  Vector3d lower = Vector3d::Constant(kInfinity), upper = -lower;
  for (const std::uint32_t t : part.triangles) {
    lower = lower.cwiseMin(middle(t));
    upper = upper.cwiseMax(middle(t));
  }
  int axis;
  (upper - lower).maxCoeff(&axis);
  auto& all = part.triangles;
  const auto half = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
  std::nth_element(all.begin(), half, all.end(), [&](std::uint32_t s, std::uint32_t t) {
    const double a = middle(s)[axis], b = middle(t)[axis];
    return a != b ? a < b : s < t;
  });
  return {makePart(mesh, {all.begin(), half}), makePart(mesh, {half, all.end()})};
}

}  // namespace

SurfaceParts::SurfaceParts(const geometry::TriangleMesh& mesh, const geometry::Surface& surface) {
  std::vector<std::uint32_t> all(mesh.triangles.size());
  for (std::size_t t = 0; t < all.size(); ++t) all[t] = static_cast<std::uint32_t>(t);
  if (all.empty()) return;
  std::vector<Part> parts;
  parts.push_back(makePart(mesh, std::move(all)));
  const geometry::EnclosingSphere whole = geometry::minimalSphere(parts.front().corners);
  const double convex = kConvex * whole.radius;
  while (parts.size() < kMax) {
    Part& worst = worstOf(parts);
    if (worst.gap <= convex || worst.triangles.size() < 2) break;
    auto [first, second] = halves(mesh, worst);
    worst = std::move(first);
    parts.push_back(std::move(second));
  }
  *this = SurfaceParts(whole);
  if (parts.size() == 1) return;
  hulls_.reserve(parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const geometry::EnclosingSphere sphere = geometry::minimalSphere(parts[i].corners);
    setSphere(i, sphere);
    hulls_.emplace_back(parts[i].corners, sphere.centre, surface);
  }
}

SurfaceParts::SurfaceParts(const geometry::EnclosingSphere& sphere) {
  std::fill_n(spheres_.radius, kMax, -static_cast<float>(kInfinity));
  setSphere(0, sphere);
}

void SurfaceParts::setSphere(std::size_t part, const geometry::EnclosingSphere& sphere) {
  spheres_.x[part] = static_cast<float>(sphere.centre.x());
  spheres_.y[part] = static_cast<float>(sphere.centre.y());
  spheres_.z[part] = static_cast<float>(sphere.centre.z());
  spheres_.radius[part] =
      static_cast<float>(sphere.radius + kHullSphereRounding * (sphere.radius + sphere.centre.norm()));
}

std::size_t SurfaceParts::memoryBytes() const {
  std::size_t bytes = hulls_.capacity() * sizeof(HullPoints);
  for (const HullPoints& hull : hulls_) bytes += hull.memoryBytes();
  return bytes;
}

}  // namespace abstand::structure
