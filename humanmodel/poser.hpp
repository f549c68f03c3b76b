// From a skeleton to the poses of the parts.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "humanmodel/human_model.hpp"

namespace abstand::humanmodel {

/// How a part's pose came about. none: never seen, the pose means nothing. held: its joints were missing, the
/// last pose stands (stale, never safe). inferred: the tracker guessed a joint, or a rule filled one in.
enum class PartState : std::uint8_t { kNone, kHeld, kInferred, kTracked };

struct HumanPose {
  std::array<Transform, kBodyPartCount> X_WP;
  std::array<PartState, kBodyPartCount> state;
  std::array<double, kBodyPartCount> age;  ///< s since the part was last seen; infinite before the first time
  /// m, as in SkeletonFrame, when it was last seen: the largest of its joints and of the part that carries it
  /// (of a thigh: the hips), since errors go on from part to part; 0: not known.
  std::array<double, kBodyPartCount> spread;

  HumanPose() {
    X_WP.fill(Transform::Identity());
    state.fill(PartState::kNone);
    age.fill(kInfinity);
    spread.fill(0.0);
  }
};

/// Puts the parts of a model onto skeletons. The joints follow the directions of the recording and keep the
/// model's bone lengths, built outwards from the hip centre, or, with `follow_lengths`, stand where the
/// recording has them.
///
/// The hips' height above the floor is scaled by the ratio of leg lengths (model over recording), so that a
/// model with longer legs stands on the floor instead of through it; nothing else of the recording's place is
/// changed.
///
/// Twist about a bone: arms and legs take it from the bend of the elbow or knee; a straight limb carries its
/// last twist along with the part that it hangs on, and the joint may pass through straight without a flip.
/// Hands follow the forearm, the head the torso, feet the calf.
///
/// Missing joints: a hand continues the forearm, a foot points forward of the body, a head continues the
/// torso; the torso does with hips or pelvis and any of neck, thorax, shoulders, spine, and hangs on the
/// latter without hips. Any other part whose joints are missing is held at its last pose relative to the part
/// that carries it.
///
/// One poser serves one person and one thread. The model must outlive it.
class Poser {
 public:
  /// `floor`: height of the floor in the frames, m.
  explicit Poser(const HumanModel& model, bool follow_lengths = false, double floor = 0.0);

  /// Takes the legs of the recording from medians over the whole of it, instead of from every frame for
  /// itself: noisy legs then do not move the hips. Where the recording's floor is the poser's, heights are
  /// scaled above the ankles: ankles that stood in the recording stand at the model's own height. May
  /// allocate.
  void calibrate(std::span<const SkeletonFrame> recording);

  /// No allocation, no throw. A frame with numbers that are not finite changes nothing but state and age.
  /// Frames come in the order of time; a step back in time (a loop, a jump) adds nothing to the ages.
  void pose(const SkeletonFrame& frame, HumanPose& out);

  /// Forgets all poses, as before the first frame; the calibration stays.
  void reset();

 private:
  /// Orientation of a part, and the point A that fixes its place: the same point in the world and in the
  /// part.
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
  double spreadOf(BodyPart part, const SkeletonFrame& frame) const;
  Matrix3d carried(BodyPart part) const;
  Transform held(BodyPart part) const;
  double liftOf(double hip_height, const SkeletonFrame& frame);

  const HumanModel* model_;
  bool follow_lengths_;
  double floor_;
  double leg_ratio_{1.0};
  bool calibrated_{false};
  double recorded_ankle_{0.0}, model_ankle_{0.0};  ///< m, above the floor when standing; 0 where not known
  double lift_{0.0};                               ///< m, added to recorded heights
  std::array<Vector3d, kBodyPartCount>
      p_joint_on_parent_;  ///< of each part's inner joint, in the parent's frame
  HumanPose before_;       ///< of the last frame
  HumanPose now_;          ///< being built, parents first
  double last_t_{kNaN};
};

}  // namespace abstand::humanmodel
