// Follows one person through depth images.
#pragma once

#include <optional>
#include <random>

#include "tracking/tracker/hidden_spread.hpp"
#include "tracking/tracker/limb_search.hpp"

namespace abstand::tracking {

/// What is known of the person after an image.
struct TrackedBody {
  bool found{false};
  RigPose pose;
  RigPlacement X_WS;
  DepthMisfit misfit;
  std::array<double, kRigSegments> visible{};  ///< share of each segment that was seen where it is
  humanmodel::SkeletonFrame
      frame;  ///< joints in the world; inferred where little of their segment was seen, missing when lost
};

/// Expectation from the last two poses, fit, search for limbs that were left behind, fit again. A person is
/// first looked for upright, in front of the camera and facing it, or with the back to it (expectAway());
/// turned up to 60 degrees from there is found too. After that left stays left, as nothing moves far between
/// two images. Lost when more than a third of the person's points lie far from the body for some images; then
/// looked for anew, within a second as the person last stood.
///
/// One tracker follows one person, on one thread. The rig must outlive it. track() allocates nothing after
/// the first image; it does not throw.
class BodyTracker {
 public:
  explicit BodyTracker(const BodyRig& rig, std::uint64_t seed = 1);

  /// `t` (s) rises. `is_person` of every pixel; with no pixel set the person is not in view, and lost.
  const TrackedBody& track(double t, const DepthImage& image, const DepthCamera& camera,
                           std::span<const std::uint8_t> is_person);
  /// Who is first looked for has the back to the camera.
  void expectAway() { away_ = true; }
  /// Standard deviation of the stature of the rig, m; 0: it is known. Every joint is known less well by it.
  void setStatureDeviation(double deviation) { stature_deviation_ = deviation; }
  /// Goes on from a pose, as if it had been found in the last image.
  void resume(const RigPose& pose);
  const TrackedBody& body() const { return body_; }
  const BodyObservation& seen() const { return seen_; }

 private:
  void find();
  void follow(double dt);
  void searchLimbs(int arm_tries, double arm_spread, int leg_tries, double leg_spread);
  void finish(double t);

  const BodyRig* rig_;
  DepthFit fit_;
  LimbSearch limbs_;
  BodyObservation seen_;
  HiddenSpread hidden_;
  std::mt19937_64 random_;
  TrackedBody body_;
  BodySolver::Vector velocity_{BodySolver::Vector::Zero()};  ///< rad/s, m/s
  DepthFit::Weights wide_, narrow_;
  double last_t_{kNaN}, found_t_{kNaN};  ///< s, of the last image, and of the last with the body
  std::optional<double> front_;          ///< rad, where the person last faced
  double stature_deviation_{0.0};        ///< m
  bool away_{false};                     ///< until somebody is found
  int badly_{0};                         ///< images in a row that the body did not explain
};

}  // namespace abstand::tracking
