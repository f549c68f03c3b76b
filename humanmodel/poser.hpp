// Poses of the body parts from a skeleton.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "humanmodel/human_model.hpp"

namespace abstand::humanmodel {

/// Origin of a part's pose. none: never seen, pose undefined. held: its joints were missing, the last pose is
/// kept (stale, never safe). inferred: a joint was guessed by the tracker or filled in by a rule.
enum class PartState : std::uint8_t { kNone, kHeld, kInferred, kTracked };

struct HumanPose {
  std::array<Transform, kBodyPartCount> X_WP;
  std::array<PartState, kBodyPartCount> state;
  std::array<double, kBodyPartCount> age;  ///< s since the part was last seen; infinite if never
  /// m, as in SkeletonFrame, when it was last seen: maximum over its joints and the part that carries it (for
  /// a thigh: the hips), since errors propagate; 0: unknown.
  std::array<double, kBodyPartCount> spread;
  /// m^2, axes of X_WP's world: an upper bound of the covariances of those joints. No point of a part that
  /// was seen is displaced along a unit vector d by more than kSpreadQuantile times the smaller of `spread`
  /// and sqrt(d . covariance d), if its joints are in their ellipsoids. Zero: `spread` in all directions.
  std::array<Matrix3d, kBodyPartCount> covariance;

  HumanPose() {
    X_WP.fill(Transform::Identity());
    state.fill(PartState::kNone);
    age.fill(kInfinity);
    spread.fill(0.0);
    covariance.fill(Matrix3d::Zero());
  }
};

/// Fits the parts of a model to skeletons. Joints follow the directions of the recording with the model's
/// bone lengths, built outwards from the hip centre; with `follow_lengths` they are placed as recorded.
///
/// The hips' height above the floor is scaled by the ratio of leg lengths (model over recording), so that a
/// model with longer legs stands on the floor; the position is not changed otherwise.
///
/// Twist about a bone: arms and legs take it from the bend of the elbow or knee. A straight limb keeps its
/// last twist relative to the part that carries it, and the joint may pass through straight without a flip.
/// Hands follow the forearm, the head the torso, feet the calf. SkeletonFrame::lateral, where stated,
/// determines the twist of straight limbs, forearms, hands, the head and feet.
///
/// Missing joints: a hand continues the forearm, a foot points forward of the body, a head continues the
/// torso. The torso needs hips or pelvis and any of neck, thorax, shoulders, spine; without hips it is placed
/// by the latter. Any other part with missing joints is held at its last pose relative to the part that
/// carries it.
///
/// One poser for each person and thread. The model must outlive it.
class Poser {
 public:
  /// `floor`: height (m) of the floor in the frames.
  explicit Poser(const HumanModel& model, bool follow_lengths = false, double floor = 0.0);

  /// Determines the recording's leg lengths as medians over all frames instead of from every frame: noisy
  /// legs then do not move the hips. If the recording's floor is the poser's, heights are scaled above the
  /// ankles: standing ankles get the model's ankle height. May allocate.
  void calibrate(std::span<const SkeletonFrame> recording);

  /// No allocation, no throw. A frame with values that are not finite changes only state and age. Frames are
  /// in order of time; a step back (a loop, a jump) does not increase the ages.
  void pose(const SkeletonFrame& frame, HumanPose& out);

  /// Discards all poses; the calibration is kept.
  void reset();

 private:
  /// Orientation of a part, and the reference point A that fixes its position: in the world and in the part.
  struct Aim {
    Matrix3d R_WP;
    JointState quality;
    Vector3d p_WA{Vector3d::Constant(kNaN)}, p_PA{Vector3d::Constant(kNaN)};
  };
  using MaybeAim = std::optional<Aim>;

  MaybeAim aim(BodyPart part, const SkeletonFrame& frame);
  MaybeAim aimTorso(const SkeletonFrame& frame);
  MaybeAim aimHead(const SkeletonFrame& frame) const;
  MaybeAim aimUpperLimb(BodyPart part, const SkeletonFrame& frame) const;
  MaybeAim aimLowerLimb(BodyPart part, const SkeletonFrame& frame) const;
  MaybeAim aimHand(BodyPart part, const SkeletonFrame& frame) const;
  MaybeAim aimFoot(BodyPart part, const SkeletonFrame& frame) const;
  bool anchor(BodyPart part, const SkeletonFrame& frame, Aim& aim) const;

  bool seenNow(BodyPart part) const;
  void stateError(BodyPart part, const SkeletonFrame& frame);
  Matrix3d carried(BodyPart part) const;
  Transform held(BodyPart part) const;
  double liftOf(double hip_height, const SkeletonFrame& frame);

  const HumanModel* model_;
  bool follow_lengths_;
  double floor_;
  double leg_ratio_{1.0};
  bool calibrated_{false};
  double recorded_ankle_{0.0}, model_ankle_{0.0};  ///< m, height above the floor when standing; 0: unknown
  double lift_{0.0};                               ///< m, added to recorded heights
  std::array<Vector3d, kBodyPartCount>
      p_joint_on_parent_;  ///< inner joint of each part, in the parent's frame
  HumanPose before_;       ///< of the last frame
  HumanPose now_;          ///< being computed, parents first
  double last_t_{kNaN};
};

}  // namespace abstand::humanmodel
