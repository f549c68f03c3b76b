// Quadrature correction of a pointshell: its forces match the overlap with half-spaces.
#pragma once

#include <cstdint>
#include <vector>

#include "core/shell/half_space_overlap.hpp"
#include "core/shell/sub_triangles.hpp"

namespace abstand::shell {

/// A shell point during the correction. Body frame, m.
struct CorrectionPoint {
  Vector3d position;
  Vector3d normal;            ///< unit, inwards
  double area;                ///< m^2
  Vector3d initial_position;  ///< initial position
  double initial_area;        ///< initial area
  double max_shift;           ///< largest allowed distance from `initial_position`
};

/// A set of half-spaces pressed into a body, each with its exact force (half_space_overlap.hpp). The force of
/// the shell is sum_i a_i max(0, d(p_i)) n_i with inward normals. A sum over few points has errors, because a
/// point enters a half-space at once and its patch of surface gradually. Shifts of a few hundredths of the
/// spacing and area changes of a few percent are enough to cancel them.
class QuadratureCorrection {
 public:
  /// Half-space directions are uniform over the sphere, plus those in which sharp edges touch first; depths
  /// are 0.75 to 2.2 spacings. Only points that a half-space reaches are adjusted. The result does not depend
  /// on the number of threads.
  QuadratureCorrection(const HalfSpaceOverlap& body, const std::vector<SharpEdge>& sharp_edges,
                       const std::vector<CorrectionPoint>& points, double spacing, int threads);

  enum class Variables { kPositionAndArea, kArea };
  /// Kaczmarz method (1937): the half-spaces are processed one by one, each with the smallest change that
  /// corrects it, with decreasing relaxation, so that contradictions average out. Positions move in the
  /// tangent plane, within their `max_shift`; areas stay between kMinArea and kMaxArea times the initial
  /// ones. `points`: those given to the constructor, within `max_shift` of their initial positions.
  void adjust(std::vector<CorrectionPoint>& points, Variables variables) const;

  /// True if point i is in one of the half-spaces; other points are not changed.
  bool isPressed(std::size_t i) const { return pressed_[i]; }

  static constexpr double kMaxShift = 0.25;  ///< spacings
  static constexpr float kMinArea = 0.4f;
  static constexpr float kMaxArea = 2.0f;

 private:
  struct HalfSpaceSample {
    Vector3d direction;
    double level;
    Vector3d force;  ///< exact force for stiffness 1
    double weight;   ///< relaxation factor; smaller for shallow half-spaces, which few points cannot match
    std::uint32_t first,
        count;  ///< of its points in points_; padded to whole lanes with the index beyond the last
  };

  double spacing_;
  std::vector<HalfSpaceSample> half_spaces_;  ///< in processing order
  std::vector<std::uint32_t> order_;          ///< position -> point, in Morton order
  std::vector<std::uint32_t> points_;         ///< positions of the points of all presses
  std::vector<bool> pressed_;                 ///< for each point
};

}  // namespace abstand::shell
