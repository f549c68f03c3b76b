// A body's surface in pieces that are about convex.
#pragma once

#include <algorithm>
#include <vector>

#include "core/geometry/enclosing_sphere.hpp"
#include "core/kernels/sphere_group.hpp"
#include "core/structure/hull_points.hpp"

namespace abstand::structure {

/// Groups of triangles, each with its hull and a sphere about it. Where a body is bent or has a flange, its
/// hull is far from its surface; the hulls of its parts are near, and two bodies are at least as far apart as
/// the nearest two of their parts. Nothing needs to be closed for that. Body frame, m. Constant after
/// construction; any number of threads.
class SurfaceParts {
 public:
  static constexpr std::size_t kMax = kernels::SphereGroup::kMax;

  SurfaceParts() = default;
  /// The part that is least convex is halved, until all are or there are kMax.
  SurfaceParts(const geometry::TriangleMesh& mesh, const geometry::Surface& surface);
  /// A convex body is one part, whose hull is the body's own.
  explicit SurfaceParts(const geometry::EnclosingSphere& sphere);

  std::size_t size() const { return std::max<std::size_t>(1, hulls_.size()); }
  /// Of one among several.
  const HullPoints& hull(std::size_t part) const { return hulls_[part]; }
  const kernels::SphereGroup& spheres() const { return spheres_; }
  std::size_t memoryBytes() const;
  template <class Archive>
  void archive(Archive& ar) {
    ar(hulls_, spheres_.x, spheres_.y, spheres_.z, spheres_.radius);
  }

 private:
  void setSphere(std::size_t part, const geometry::EnclosingSphere& sphere);

  std::vector<HullPoints> hulls_;  ///< none where the whole is one part
  kernels::SphereGroup spheres_{};
};

}  // namespace abstand::structure
