// The fit of the rig to what a depth camera sees of a person.
#pragma once

#include <vector>

#include "tracking/body/body_solver.hpp"
#include "tracking/tracker/fit_surface.hpp"

namespace abstand::tracking {

/// How well a pose explains an image.
struct DepthMisfit {
  double cost{kInfinity};  ///< m^2: mean over points and over samples in free space, robust
  double explained{0.0};   ///< share of the points within 5 cm of the segment that they lie on
  double residual{kNaN};   ///< m, root mean square of those
};

/// Points of the image are to lie on the surface of the segment that explains them best, by distance and
/// normal, on its side that faces the camera (Ganapathi and others, ECCV 2012). Points on the axes of the
/// segments are not to lie where the camera looks past the person, nor before what it measured, nor inside
/// the trunk, the head or the other leg. Not shared between threads; no allocation, no throw.
class DepthFit {
 public:
  explicit DepthFit(const BodyRig& rig);

  const BodyRig& rig() const { return *rig_; }
  const FitSurfaces& surfaces() const { return surfaces_; }

  struct Weights {
    BodySolver::Vector prior{BodySolver::Vector::Zero()};  ///< towards the pose that is expected
    double reach{0.10};  ///< m, residuals beyond it lose their weight (Geman, McClure 1985)
  };
  /// `steps` of Gauss-Newton from `pose`, which is made better. `expected` may be `pose` itself: every step
  /// is then held to where it begins.
  void refine(const BodyObservation& seen, const RigPose& expected, const Weights& weights, int steps,
              RigPose& pose);

  /// The last step of refine(), its points weighing 1 each at most and 1,000 all together.
  const BodySolver& problem() const { return solver_; }

  DepthMisfit misfit(const BodyObservation& seen, const RigPlacement& X_WS);

  /// Of every point, how ill the best segment fits among those of the mask; after refine() or misfit().
  void scores(const SeenPoints& points, const RigPlacement& X_WS, std::uint32_t segments, float* best) const;
  /// Robust mean square of scores.
  static double robustMean(const float* score, std::size_t count);
  /// Cost of the samples of these segments in free space and in other segments, m^2.
  double placeCost(const BodyObservation& seen, const RigPlacement& X_WS, std::uint32_t segments) const;
  /// Share of the samples of each segment that the camera sees where the pose has them.
  void visibility(const BodyObservation& seen, const RigPlacement& X_WS,
                  std::array<double, kRigSegments>& share) const;

  static constexpr std::uint32_t kAll = (1u << kRigSegments) - 1u;
  static constexpr std::uint32_t bit(RigSegment s) { return 1u << index(s); }

 private:
  struct Sample {
    RigSegment segment;
    Vector3d p_S;
    double radius;  ///< m, of the segment there
  };
  struct Violation {
    Vector3d n;  ///< world; against the way out
    double depth{0.0};
  };
  Violation violation(const BodyObservation& seen, const Sample& sample, const Vector3d& p_W) const;
  /// Of a sample in a segment that it must not be in.
  Violation overlap(const Sample& sample, const Vector3d& p_W, std::size_t other,
                    const Transform& X_WS) const;
  void assign(const SeenPoints& points, const RigPlacement& X_WS);

  const BodyRig* rig_;
  FitSurfaces surfaces_;
  std::vector<Sample> samples_;
  BodySolver solver_;
  std::array<std::uint8_t, SeenPoints::kMax> segment_{};
  mutable std::array<float, SeenPoints::kMax> best_{}, score_{};
};

}  // namespace abstand::tracking
