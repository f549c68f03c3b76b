// Initial poses of people who lie, and which of their fits count.
#pragma once

#include "tracking/tracker/alike_fits.hpp"
#include "tracking/tracker/body_view.hpp"

namespace abstand::tracking {

/// m, of a person who stands.
double vertexAbovePelvis(const BodyRig& rig);

/// What is known of a person who was found lying, or low, as bent.
struct Lying {
  bool lies{false};              ///< found by this search, and low since
  JointRadii apart{};            ///< LyingFits::apart(), or AlikeFits::apart()
  double front_over_back{kNaN};  ///< LyingFits::frontOverBack() of the last search; NaN: of none
};

struct LyingStart {
  RigPose pose;
  bool on_front{false};  ///< else on the back
};
inline constexpr std::size_t kLyingStarts = 8;

/// Along the longest horizontal extent of the points, which passes `middle`: on the back and on the front,
/// with the head at either end, the arms along the body or bent beside the head. No allocation, no throw.
void lyingStarts(const BodyRig& rig, const SeenPoints& points, const Vector3d& middle,
                 std::array<LyingStart, kLyingStarts>& starts);

/// Fits from these starts to one image. Low bodies look alike from above: it keeps those that explain the
/// image nearly as well as the best one. No allocation, no throw.
class LyingFits {
 public:
  explicit LyingFits(const BodyRig& rig) : rig_{&rig} {}
  /// `cost` and `gap`: of DepthFit, for the pose. Returns whether it is the best so far on its side.
  bool add(double cost, const RigPlacement& X_WS, const std::array<double, kRigSegments>& gap, bool on_front);
  /// Whether the best fit is on the front: the side with the smallest cost.
  bool onFront() const;
  /// Smallest cost on the front over that on the back; NaN unless both sides were tried.
  double frontOverBack() const;
  /// Whether both sides were tried, and one explains the image about as well as the other.
  bool sidesAlike() const;
  /// m, for each joint: the distance of the farthest place in the other fits that explain the image about as
  /// well, from the best fit; of those on the other side, from the best fit turned round.
  JointRadii apart() const;

 private:
  struct Fit {
    double cost{kInfinity}, rank{kInfinity};
    humanmodel::SkeletonFrame frame;
    bool on_front{false};
  };
  const BodyRig* rig_;
  std::array<Fit, kLyingStarts> fits_;
  std::size_t count_{0};
  std::array<double, 2> least_{kInfinity, kInfinity};  ///< cost on the back and on the front
  std::array<std::size_t, 2> best_{};                  ///< likewise, the fit of the lowest rank
};

}  // namespace abstand::tracking
