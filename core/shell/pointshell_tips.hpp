// Where a surface comes to a point or an edge, so that a contact there is small and needs more shell points.
#pragma once

#include "core/shell/pointshell_sharp_edges.hpp"
#include "core/shell/pointshell_tree.hpp"

namespace abstand::shell {

/// Corners and strongly curved tips: places that turn by at least one radian of solid angle (Gaussian
/// curvature, summed as angle defects of the vertices) within about 1.5 `scale` (m). Body frame. Edges and
/// flat or gently curved places are none.
std::vector<Vector3f> findTips(const geometry::TriangleMesh& mesh, double scale);

/// How close the shell points should lie at a place, as a multiple of the spacing: 1, and less near tips and
/// sharp convex edges, so that the small overlap of a corner or an edge pressed in a little is still felt by
/// enough points.
class PitchField {
 public:
  static constexpr double kSmallest = 0.4;  ///< at a tip

  PitchField(const geometry::TriangleMesh& mesh, double spacing);

  /// The tip and the sharp edge that are nearest to a place.
  struct Near {
    static constexpr std::uint32_t kNone = 0xffffffffu;
    std::uint32_t tip{kNone}, sharp_edge{kNone};
    bool none() const { return tip == kNone && sharp_edge == kNone; }
  };
  /// None where the pitch is 1 everywhere within `around` (m) of p.
  Near near(const Vector3d& p, double around) const;
  /// The pitch at p, by what is near a place nearby.
  double pitch(const Vector3d& p, const Near& near) const;
  /// 1 everywhere.
  bool plain() const { return tips_.empty() && sharpEdges().empty(); }
  const std::vector<std::uint8_t>& sharp() const { return edges_.sharp; }
  const std::vector<SharpEdge>& sharpEdges() const { return edges_.sharp_edges; }

 private:
  double spacing_;
  SharpEdges edges_;
  std::vector<Vector3f> tips_;
  NearestOfPoints nearest_tip_, nearest_on_sharp_edge_;
  std::vector<std::uint32_t> sharp_edge_of_;  ///< of each point along the sharp edges
};

}  // namespace abstand::shell
