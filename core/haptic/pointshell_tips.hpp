// Where a surface comes to a point, so that a contact there is small and needs more shell points.
#pragma once

#include "core/geometry/triangle_mesh.hpp"
#include "core/haptic/pointshell_tree.hpp"

namespace abstand {

/// Corners and strongly curved tips: places that turn by at least one radian of solid angle (Gaussian
/// curvature, summed as angle defects of the vertices) within about 1.5 `scale` (m). Body frame. Edges and
/// flat or gently curved places are none.
std::vector<Vector3f> findTips(const TriangleMesh& mesh, double scale);

/// How close the shell points should lie at a place, as a multiple of the spacing: 1, and less near tips.
class TipField {
 public:
  static constexpr double kSmallest = 0.4;  ///< at a tip
  static constexpr double kReach = 6.0;     ///< spacings from a tip, from where on it is 1

  TipField(const TriangleMesh& mesh, double spacing);
  double pitch(const Vector3d& p) const;
  bool empty() const { return tips_.empty(); }

 private:
  double reach_;
  NearestPoint tips_;
};

}  // namespace abstand
