// Fine adjustment of a pointshell, so that pressing the body into a wall gives the overlap.
#pragma once

#include <cstdint>
#include <vector>

#include "core/shell/half_space_overlap.hpp"
#include "core/shell/sub_triangles.hpp"

namespace abstand::shell {

/// A shell point while it is adjusted. Body frame, m.
struct BalancePoint {
  Vector3d position;
  Vector3d normal;   ///< unit, inwards
  double area;       ///< m^2
  Vector3d home;     ///< where it was at first
  double home_area;  ///< what it stood for at first
  double reach;      ///< how far from home it may go
};

/// Half-spaces pressed into a body, and what the force law should give for each (half_space_overlap.hpp):
/// sum_i a_i max(0, d(p_i)) n_i with the points' inward normals. Sums over few points cannot be right for
/// all of them, as each point enters at once what its piece of the surface enters little by little. But
/// points and areas have enough freedom for their errors to cancel: shifts of a few hundredths of the spacing
/// and a few percent of area do.
class QuadratureCorrection {
 public:
  /// Directions all around, and those in which edges and their neighbourhood come first; depths from three
  /// quarters of a spacing to two and a half. Only the places that a flat wall can reach are adjusted. The
  /// result does not depend on the number of threads.
  QuadratureCorrection(const HalfSpaceOverlap& body, const std::vector<SharpEdge>& sharp_edges,
                       const std::vector<BalancePoint>& points, double spacing, int threads);

  enum class Freedom { kPlaceAndArea, kArea };
  /// Row-action least squares (Kaczmarz 1937): one half-space after the other, each with the smallest change
  /// that mends it, less and less far, so that what they disagree on is averaged. Positions move within the
  /// tangent plane, within their reach; areas stay within kMinArea to kMaxArea of theirs.
  /// `points`: those given to the constructor, no farther from home than their reach.
  void adjust(std::vector<BalancePoint>& points, Freedom freedom) const;

  /// Whether point i is in one of the half-spaces: others stay as they are.
  bool presses(std::size_t i) const { return pressed_[i]; }

  static constexpr double kReach = 0.25;  ///< spacings
  static constexpr float kMinArea = 0.4f;
  static constexpr float kMaxArea = 2.0f;

 private:
  struct Press {
    Vector3d direction;
    double level;
    Vector3d force;  ///< what it should be, for stiffness 1
    double weight;   ///< how far it is mended at once: shallow ones less, as they cannot be right
    std::uint32_t first,
        count;  ///< of its points, in points_; padded to whole lanes with one beyond the last
  };

  double spacing_;
  std::vector<Press> presses_;         ///< in the order in which they are mended
  std::vector<std::uint32_t> order_;   ///< place in it -> point: neighbours in space are neighbours in memory
  std::vector<std::uint32_t> points_;  ///< their places
  std::vector<bool> pressed_;          ///< by point
};

}  // namespace abstand::shell
