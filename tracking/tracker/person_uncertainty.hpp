// Uncertainty of all joints of a person who is tracked.
#pragma once

#include "tracking/tracker/hidden_space.hpp"
#include "tracking/tracker/joint_motion.hpp"
#include "tracking/tracker/limb_alternatives.hpp"
#include "tracking/tracker/lying_start.hpp"
#include "tracking/tracker/tracked_body.hpp"

namespace abstand::tracking {

/// What is not known of a person, whatever the image shows.
struct PersonDoubts {
  double found_for;          ///< s since the person was found
  double stature_deviation;  ///< m, standard deviation of the rig's stature
  bool feet_cut;             ///< BodyTracker::areFeetCut()
  bool facing_known;         ///< BodyTracker::setFacingKnown()
  const Lying& lying;
};

/// An image at `t` (s) and the fit to it; `limbs` has searched it.
struct SearchedImage {
  double t;
  const BodyObservation& seen;
  const DepthFit& fit;
  LimbSearch& limbs;
};

/// States which joints are seen, and the covariance (m^2, world) of each joint's error:
/// - of joints that are seen: trackedCovariances(), JointMotion, LimbAlternatives;
/// - of others: HiddenSpread with HiddenSpace, and the error of the last joint of the limb that is seen, from
///   which all places are counted;
/// - of all of them: the unknown stature, other poses of a person who lies, and the place in a person who
///   faces the other way.
/// The ellipsoids of a person who was just found, or whom the body explains badly, are balls. One for each
/// person; not shared between threads. Allocates nothing after the first image.
class PersonUncertainty {
 public:
  explicit PersonUncertainty(const BodyRig& rig) : rig_{&rig}, hidden_{rig}, space_{rig} {}

  /// Whether state() sets the covariances, too, and not only which joints are seen. Initially so.
  void stateSpreads(bool states) { states_spreads_ = states; }
  /// Sets states and covariances of the joints in `body.frame` from the other values of `body`.
  void state(const SearchedImage& image, const PersonDoubts& doubts, TrackedBody& body);
  /// The person was lost.
  void forget();
  /// Takes the memory of covariances from a frame that is no longer needed.
  void reuse(humanmodel::SkeletonFrame& frame);

 private:
  void see(const SearchedImage& image, const TrackedBody& body, SeenSegments seen);
  void addTerms(const PersonDoubts& doubts, const TrackedBody& body, SeenSegments seen,
                JointCovariances& covariance) const;

  const BodyRig* rig_;
  bool states_spreads_{true};
  HiddenSpread hidden_;
  HiddenSpace space_;
  JointMotion motion_;
  LimbAlternatives alternatives_;
  humanmodel::JointMatrices memory_;  ///< of the last frame, while the next one states none
};

}  // namespace abstand::tracking
