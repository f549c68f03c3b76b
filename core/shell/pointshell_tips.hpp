// Tips and sharp edges of a surface, where contacts are small and need a denser pointshell.
#pragma once

#include "core/shell/pointshell_sharp_edges.hpp"
#include "core/shell/pointshell_tree.hpp"

namespace abstand::shell {

/// Corners and strongly curved tips (body frame): places with at least one radian of solid angle (Gaussian
/// curvature, as the sum of angle defects of vertices) within about 1.5 `scale` (m). Edges and flat or gently
/// curved places do not qualify.
std::vector<Vector3f> findTips(const geometry::TriangleMesh& mesh, double scale);

/// Local pitch of the shell points as a multiple of the spacing: 1, and smaller near tips and sharp convex
/// edges, so that the small overlap of a corner or an edge at low depth is sampled by enough points.
class PitchField {
 public:
  static constexpr double kSmallest = 0.4;  ///< at a tip

  PitchField(const geometry::TriangleMesh& mesh, double spacing);

  /// Nearest tip and nearest sharp edge of a place.
  struct Near {
    static constexpr std::uint32_t kNone = 0xffffffffu;
    std::uint32_t tip{kNone}, sharp_edge{kNone};
    bool none() const { return tip == kNone && sharp_edge == kNone; }
  };
  /// Tip and sharp edge nearest to p; none if the pitch is 1 everywhere within `around` (m) of p.
  Near near(const Vector3d& p, double around) const;
  /// The pitch at p; `near` is the result of near() for a place nearby.
  double pitch(const Vector3d& p, const Near& near) const;
  /// True if the pitch is 1 everywhere.
  bool isUniform() const { return tips_.empty() && sharpEdges().empty(); }
  const std::vector<std::uint8_t>& sharp() const { return edges_.sharp; }
  const std::vector<SharpEdge>& sharpEdges() const { return edges_.sharp_edges; }

 private:
  double spacing_;
  SharpEdges edges_;
  std::vector<Vector3f> tips_;
  NearestOfPoints nearest_tip_, nearest_on_sharp_edge_;
  std::vector<std::uint32_t> sharp_edge_of_;  ///< sharp edge of each point sampled along the sharp edges
};

}  // namespace abstand::shell
