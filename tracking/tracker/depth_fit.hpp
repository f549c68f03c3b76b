// Fits the rig to a depth observation of a person.
#pragma once

#include <vector>

#include "tracking/body/body_solver.hpp"
#include "tracking/tracker/body_observation.hpp"
#include "tracking/tracker/chair_space.hpp"
#include "tracking/tracker/fit_surface.hpp"

namespace abstand::tracking {

/// Fit quality of a pose.
struct DepthMisfit {
  double cost{kInfinity};  ///< m^2: robust mean over points and free-space samples
  double explained{0.0};   ///< share of the points within 5 cm of their segment, without those of a chair
  double residual{kNaN};   ///< m, RMS distance of those
};

/// Points of all images attract the surface of the segment that explains them best, by distance and normal,
/// on its side facing the camera that saw them (Ganapathi and others, ECCV 2012). Sample points on the axes
/// of the segments must not be in free space of any camera, nor in front of the measured surface, nor inside
/// of the trunk, the head or the other leg. Of a person who sits, points in the ChairSpace attract nothing,
/// unless a segment explains them better than kChairMisfit. Not shared between threads; no allocation, no
/// throw.
class DepthFit {
 public:
  explicit DepthFit(const BodyRig& rig);

  const BodyRig& rig() const { return *rig_; }
  const FitSurfaces& surfaces() const { return surfaces_; }
  /// Whether the body must stay above the floor z = 0, too, as for people who lie on it. Initially not.
  void keepAboveFloor(bool above) { above_floor_ = above; }
  /// Whether the axes of both legs keep apart (LegContact), as of people who may sit. Initially not.
  void keepLegsApart(bool apart) { legs_apart_ = apart; }
  /// Whether the ChairSpace of a person who sits explains points. Initially so.
  void allowChair(bool allowed) { allows_chair_ = allowed; }

  struct Weights {
    BodySolver::Vector prior{BodySolver::Vector::Zero()};  ///< weight towards the expected pose
    double reach{0.10};  ///< m, scale of the robust weight: larger residuals lose influence (Geman, McClure
                         ///< 1985)
    std::uint32_t planted{0};  ///< feet that rest on the floor z = 0, as hidden ones do
    double untwist{0.0};       ///< 1/rad^2, of hanging thighs seen exactly from the side, towards no twist
  };
  /// `steps` Gauss-Newton steps from `pose`, which is updated. `expected` may be `pose` itself: then every
  /// step is regularised towards its start.
  void refine(const BodyObservation& seen, const RigPose& expected, const Weights& weights, int steps,
              RigPose& pose);

  /// Normal equations of the last step of refine(), with points weighted at most 1 each and 1,000 in total.
  const BodySolver& problem() const { return solver_; }

  DepthMisfit misfit(const BodyObservation& seen, const RigPlacement& X_WS);

  /// Misfit of every point to its best segment among those of the mask; after refine() or misfit().
  void scores(const SeenPoints& points, const RigPlacement& X_WS, std::uint32_t segments, float* best) const;
  /// Lowers `best` to these.
  void lowerToScores(const SeenPoints& points, const RigPlacement& X_WS, std::uint32_t segments,
                     float* best) const;
  /// Lowers `best` to kChairMisfit for points in the ChairSpace of the pose; where it is lowered, `segment`,
  /// unless null, becomes kChair.
  void lowerToChair(const SeenPoints& points, const RigPlacement& X_WS, float* best,
                    std::int32_t* segment = nullptr) const;
  /// Robust squares of scores, m^2.
  static double robustSum(const float* score, std::size_t count);
  static double robustMean(const float* score, std::size_t count);
  /// Cost (m^2) of the samples of these segments in free space and in other segments.
  double placeCost(const BodyObservation& seen, const RigPlacement& X_WS, std::uint32_t segments) const;
  /// Share of the samples of each segment that any camera sees at the pose.
  void visibility(const BodyObservation& seen, const RigPlacement& X_WS,
                  std::array<double, kRigSegments>& share) const;

  /// How many points each segment alone explains: the sum over the points of the cost that the others add
  /// without it, in units of that of an unexplained point. A segment without any may be elsewhere as well.
  void support(const BodyObservation& seen, const RigPlacement& X_WS,
               std::array<double, kRigSegments>& points) const;

  /// m, for each segment of a limb: smallest distance of its surface to what it can be confused with: of an
  /// arm the trunk, the head and the thighs, of a leg the other leg. Negative: inside. Infinite for the
  /// trunk, the head and the upper arms.
  void gaps(const RigPlacement& X_WS, std::array<double, kRigSegments>& gap) const;

  static constexpr std::uint32_t kAll = (1u << kRigSegments) - 1u;
  static constexpr std::uint32_t bit(RigSegment s) { return 1u << index(s); }

 private:
  struct Sample {
    RigSegment segment;
    Vector3d p_S;
    double radius;  ///< m, of the segment at the sample
  };
  struct Violation {
    Vector3d n;  ///< world; opposite to the direction out
    double depth{0.0};
  };
  static Violation violation(const BodyView& view, const Sample& sample, const Vector3d& p_W);
  /// The deepest violation of all views.
  static Violation violation(const BodyObservation& seen, const Sample& sample, const Vector3d& p_W);
  /// Violation of a sample inside of a segment that it must not enter.
  Violation overlap(const Sample& sample, const Vector3d& p_W, std::size_t other,
                    const Transform& X_WS) const;
  /// Violation of a sample below the floor; none unless keepAboveFloor().
  Violation sunk(const Sample& sample, const Vector3d& p_W) const;
  void assign(const SeenPoints& points, const RigPlacement& X_WS);
  void addUntwist(const BodyObservation& seen, double weight);

  const BodyRig* rig_;
  FitSurfaces surfaces_;
  std::vector<Sample> samples_;
  BodySolver solver_;
  bool above_floor_{false};
  bool allows_chair_{true};
  bool legs_apart_{false};
  static constexpr std::int32_t kChair = static_cast<std::int32_t>(kRigSegments);
  std::array<std::int32_t, SeenPoints::kMax> segment_{};  ///< or kChair
  std::array<Vector3d, SeenPoints::kMax> ray_;  ///< of refine(): from the camera to each point, unit, world
  mutable std::array<float, SeenPoints::kMax> best_{}, score_{};
};

}  // namespace abstand::tracking
