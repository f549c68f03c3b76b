// Approximate convex decomposition of a body's surface.
#pragma once

#include <algorithm>
#include <vector>

#include "core/geometry/enclosing_sphere.hpp"
#include "core/kernels/sphere_group.hpp"
#include "core/structure/hull_points.hpp"

namespace abstand::structure {

/// Groups of triangles, each with its convex hull and a bounding sphere. For bodies that are bent or have a
/// flange, the hulls of the parts are much closer to the surface than the hull of the body. The distance of
/// two bodies is at least that of their nearest two parts, also if the surface is not closed. Body frame, m.
/// Constant after construction; any number of threads.
class SurfaceParts {
 public:
  static constexpr std::size_t kMax = kernels::SphereGroup::kMax;

  SurfaceParts() = default;
  /// Bisects the least convex part until all are convex or there are kMax.
  SurfaceParts(const geometry::TriangleMesh& mesh, const geometry::Surface& surface);
  /// A convex body: one part, whose hull is that of the body.
  explicit SurfaceParts(const geometry::EnclosingSphere& sphere);

  std::size_t size() const { return std::max<std::size_t>(1, hulls_.size()); }
  /// Hull of one of several parts.
  const HullPoints& hull(std::size_t part) const { return hulls_[part]; }
  const kernels::SphereGroup& spheres() const { return spheres_; }
  std::size_t memoryBytes() const;
  template <class Archive>
  void archive(Archive& ar) {
    ar(hulls_, spheres_.x, spheres_.y, spheres_.z, spheres_.radius);
  }

 private:
  void setSphere(std::size_t part, const geometry::EnclosingSphere& sphere);

  std::vector<HullPoints> hulls_;  ///< empty if there is one part
  kernels::SphereGroup spheres_{};
};

}  // namespace abstand::structure
