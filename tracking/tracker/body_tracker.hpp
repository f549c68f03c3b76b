// Tracks one person through depth images.
#pragma once

#include <optional>
#include <random>

#include "tracking/tracker/backoff.hpp"
#include "tracking/tracker/leg_posture.hpp"
#include "tracking/tracker/other_facing.hpp"
#include "tracking/tracker/person_uncertainty.hpp"

namespace abstand::tracking {

/// Initial posture of a search.
struct StartPosture {
  double lower;     ///< m, of the pelvis below that of a person who stands as high as the head
  bool bends_legs;  ///< else the legs are straight
  Vector3d p_ankle{Vector3d::Zero()};      ///< m, from the hip, pelvis' axes
  double wrists{0.0};                      ///< m, of raised arms: above the shoulders; 0: the arms hang
  std::array<bool, 2> raises{true, true};  ///< left, right
};

/// Steps for each moment, of which there is one image or one of each camera: prediction from the last two
/// poses, fit, search for limbs left behind, second fit. The initial search assumes a person upright and
/// facing a camera, or with the back to it (expectAway()), and tolerates rotations up to 60 degrees; or
/// lying, on the back or on the front, if nothing is high: where both explain the image about as well, it is
/// no longer known which way the person faces. Afterwards left and right persist, as motion
/// between two images is small. Lost when more than a third of the person's points are far from the body for
/// some images; then searched anew, within a second in the last orientation, less often if in vain.
///
/// One tracker for each person and thread. The rig must outlive it. track() allocates nothing after the first
/// image; it does not throw.
class BodyTracker {
 public:
  explicit BodyTracker(const BodyRig& rig, std::uint64_t seed = 1);

  /// `t` (s) increases. One image of each camera that looks at that time, at most BodyObservation::kMaxViews;
  /// if no pixel is set, the person is not in view, and lost.
  const TrackedBody& track(double t, std::span<const PersonImage> images);
  /// Whether the initial search assumes that the person's back is to the camera.
  void expectAway(bool away) { expected_.away = away; }
  /// The initial search of a person who does not lie starts from `yaw` (rad, world), too, and finds none who
  /// faces another way by more than 90 degrees.
  void expectFacing(double yaw) { expected_.yaw = yaw; }
  /// The initial search assumes that a person who lies does so on the front, or on the back.
  void expectLying(bool on_front) { expected_.on_front = on_front; }
  /// Whether it is known which way the person faces. If not, the reach of each joint includes its place in a
  /// person who faces the other way. Known at first; unknown again for a person who was lost for more than a
  /// second.
  void setFacingKnown(bool known) { facing_known_ = known; }
  /// Whether points behind and under a person who sits may be those of a chair (ChairSpace). Initially so.
  void allowChair(bool allowed) { fit_.allowChair(allowed); }
  /// Whether the covariances of the joints are stated. Initially so.
  void stateSpreads(bool states) { uncertainty_.stateSpreads(states); }
  /// Standard deviation (m) of the rig's stature; 0: known. Increases the uncertainty of every joint.
  void setStatureDeviation(double deviation) { stature_deviation_ = deviation; }
  /// Adds to the reach of the left and the right hand in the last image: m by which things in them extend
  /// beyond them.
  void widenHands(const std::array<double, 2>& extent);
  /// Adds to the reach of each joint in the last image that in `other`: encloseOtherFacing().
  void encloseOther(const TrackedBody& other) { encloseOtherFacing(other, body_); }
  /// Continues from a pose as if it had been found in the last image; `lying`: of the tracker that found it;
  /// `since` (s): of the first image in which it found it.
  void resume(const RigPose& pose, const Lying& lying, double since = -kInfinity);
  /// An initial search for a person who faces `yaw` (rad, world) up to 60 degrees, in the image that another
  /// tracker saw last. Sets pose and misfit of body().
  const TrackedBody& search(const BodyTracker& other, double yaw);
  const Lying& lying() const { return lying_; }
  const TrackedBody& body() const { return body_; }
  /// Whether the person was searched for in the last image, and not found. Not every image is searched.
  bool searchedInVain() const { return is_searched_ && !body_.found; }
  /// Whether the last body comes from a search that explains the image much better than the followed one did:
  /// the bodies before were wrong.
  bool wasReplaced() const { return was_replaced_; }
  /// Whether neither the head nor a whole foot of the last body is within the images. What they cut off
  /// below may be a leg that a wrong body bends into them.
  bool isCutAtBothEnds() const { return isHeadCut() && (is_cut_.below || !showsFoot()); }
  /// Whether the trunk of the last body is more level than upright.
  bool isBent() const;
  /// Whether the last body does not lie, and has both feet in the air.
  bool floats() const { return !lying_.lies && tracking::floats(body_.X_WS); }
  const BodyObservation& seen() const { return seen_; }
  const DepthFit& fit() const { return fit_; }

  /// Times the cost of a body that floats, at which one that does not is the likelier one.
  static constexpr double kFloats = 1.5;
  /// m, typical distance from the visible skin to the middle of the body.
  static constexpr double kHalfBody = 0.10;
  /// s; a person out of sight for longer may have turned around.
  static constexpr double kTurns = 1.0;

 private:
  /// Share of the stature: shoulders are at most 0.19 below the vertex of an upright head and hands reach
  /// 0.42 below them (Drillis and Contini), so that those of a higher person are clear of the floor. Those of
  /// a person who stands hang higher than markStanding() looks.
  static constexpr double kHandsOffFloor = 0.70;
  /// Likewise: lower heads do not belong to people who stand.
  static constexpr double kStandingHead = 0.85;
  /// m: people whose highest point is lower lie, perhaps with raised knees; seated on the floor, the head is
  /// at 0.8.
  static constexpr double kLyingTop = 0.65;

  /// Of the initial search, until the person is found.
  struct Expected {
    bool away{false};
    std::optional<double> yaw;     ///< rad
    std::optional<bool> on_front;  ///< of a person who lies; nullopt: both are tried
  };
  static constexpr int kStartWideSteps = 6, kStartNarrowSteps = 10, kStartRounds = 3;  ///< of a search
  void loseSight();
  void searchAgain(double t);
  void find();
  /// Of a search for somebody who does not lie.
  struct Fits {
    TrackedBody best;
    double cost;  ///< m^2, of `best`, by which fits are compared
    AlikeFits all;
  };
  void tryStarts(const Vector3d& middle, double top, double facing, Fits& fits);
  void tryRaised(const Vector3d& middle, double head, double facing, Fits& fits);
  void tryPostures(std::span<const StartPosture> postures, const Vector3d& middle, double pelvis,
                   double facing, Fits& fits);
  void tryBent(const Vector3d& middle, double top, double facing, Fits& fits);
  void tryFrom(const RigPose& start, Fits& fits, int rounds = kStartRounds);
  void tryLying(const Vector3d& middle, TrackedBody& best);
  bool mayFace(double yaw) const;
  void fitFrom(const RigPose& start, int rounds = kStartRounds);
  void placeBody();
  void uncrossLegs();
  void uncrossArms();
  void standLegs();
  void lowerLeg();
  void plantLegs();
  void lowerArms();
  bool tryLikelier(const RigPose& start, double limit);
  void follow(double dt);
  void returnTo(const RigPose& last);
  double costOf(const RigPose& pose);
  double meanDistance() const;
  void plantHiddenFeet();
  double headHeight() const;
  bool isInView(const Vector3d& p_W) const;
  bool isHeadCut() const;
  bool areFeetCut() const;
  bool showsFoot() const;
  void searchLimbs(const LimbSearch::Scope& arms, const LimbSearch::Scope& legs);
  void finish(double t);

  const BodyRig* rig_;
  DepthFit fit_;
  LimbSearch limbs_;
  BodyObservation seen_;
  PersonUncertainty uncertainty_;
  std::mt19937_64 random_;
  Backoff lost_, doubtful_;  ///< searches for a lost person, and while a body is followed that fits badly
  bool is_searched_{false};  ///< the last image was searched for a lost person
  TrackedBody body_;
  BodySolver::Vector velocity_{BodySolver::Vector::Zero()};  ///< rad/s, m/s
  DepthFit::Weights wide_, narrow_;
  double last_t_{kNaN}, found_t_{kNaN};  ///< s, of the last image, and of the last one with the body
  double appeared_t_{-kInfinity};        ///< s, the first image since the person was found
  double legs_seen_t_{-kInfinity};       ///< s, last image with a calf or a foot
  std::optional<double> front_;          ///< rad, last facing direction
  double stature_deviation_{0.0};        ///< m
  Lying lying_;
  bool was_replaced_{false};
  struct Cut {
    bool above{false};  ///< by the upper border of an image
    bool below{false};  ///< by the lower one of all images
  };
  Cut is_cut_;  ///< the person in the last images
  bool facing_known_{true};
  Expected expected_;
  int badly_{0};  ///< consecutive images that the body did not explain
};

}  // namespace abstand::tracking
