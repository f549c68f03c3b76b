// Terms of joints that are seen, of hidden ones, and of all.
#include "tracking/tracker/person_uncertainty.hpp"

#include <algorithm>
#include <cmath>

#include "humanmodel/joint_covariance.hpp"
#include "humanmodel/part_uncertainty.hpp"
#include "tracking/tracker/joint_uncertainty.hpp"
#include "tracking/tracker/seen_segments.hpp"
#include "tracking/tracker/turned_round.hpp"

namespace abstand::tracking {
namespace {

// Share of a stature error by which a joint moves: visible ones are still fitted to the observed points, more
// loosely if the images do not show where the legs end; the places of hidden ones follow from the lengths of
// the bones, and so do those of the straight limbs of who lies.
constexpr double kOfStatureSeen = 0.10, kOfStatureCut = 0.20, kOfStatureHidden = 0.30,
                 kOfStatureStraight = 0.40;
constexpr double kConfirmed = 0.2;  // s; until then, a person who was found may be in another posture

/// m^2, of a joint that may be `distance` (m) away.
double variance(double distance) {
  const double deviation = distance / humanmodel::kSpreadQuantile;
  return deviation * deviation;
}

/// The places of hidden joints are counted from the last one of the limb that is seen, which has an error,
/// too. A wrist may be `elsewhere` (m), and the hidden hand with it. Doing the same for knees made the reach
/// of feet behind a bench half as large again, although all of them were within it before.
void attachHidden(const humanmodel::SkeletonFrame& frame, const JointCovariances& tracked,
                  const LimbAlternatives::Distances& elsewhere, JointCovariances& covariance) {
  for (std::size_t k = 0; k < kLimbs.size(); ++k) {
    Matrix3d attached = Matrix3d::Zero();
    for (const humanmodel::Joint joint : kLimbJoints[k]) {
      const auto j = static_cast<std::size_t>(joint);
      if (frame.state[j] == humanmodel::JointState::kInferred) {
        covariance[j] = humanmodel::sumEnclosing(covariance[j], attached);
        continue;
      }
      attached = tracked[j];
      if (kLimbs[k].isArm()) attached.diagonal().array() += variance(elsewhere[j]);
    }
  }
}

}  // namespace

void PersonUncertainty::see(const SearchedImage& image, const TrackedBody& body, SeenSegments seen) {
  space_.update(image.seen, body.X_WS, seen);
  hidden_.see(image.t, seen, space_.extent(), space_.shape());
  motion_.see(image.t, body.frame);
  alternatives_.begin(image.t);
  for (std::size_t k = 0; k < kLimbs.size(); ++k) {
    const std::span<const LimbTry> tries = image.limbs.tries(k);
    if (!tries.empty()) alternatives_.add(k, tries, image.limbs.cost(image.seen, k, body.pose), body.X_WS);
  }
}

void PersonUncertainty::addTerms(const PersonDoubts& doubts, const TrackedBody& body, SeenSegments seen,
                                 JointCovariances& covariance) const {
  // Straight limbs on the floor do not show their joints.
  const Lying& lying = doubts.lying;
  const bool may_be_on_front = lying.lies && (!doubts.facing_known || body.pose.X_WP.linear()(2, 0) < 0.0);
  for (std::size_t j = 0; j < humanmodel::kJointCount; ++j) {
    const bool is_seen = isSeen(seen, rig_->carrier[j]);
    const double of_stature = may_be_on_front   ? kOfStatureStraight
                              : !is_seen        ? kOfStatureHidden
                              : doubts.feet_cut ? kOfStatureCut
                                                : kOfStatureSeen;
    const double stature = of_stature * doubts.stature_deviation;
    const double elsewhere = is_seen ? alternatives_.distance()[j] : 0.0;
    const double other_pose = std::max(lying.apart[j], elsewhere) / humanmodel::kSpreadQuantile;
    const double all_around = std::hypot(stature, other_pose, is_seen ? motion_.spread()[j] : 0.0);
    covariance[j].diagonal().array() += all_around * all_around;
    if (!is_seen) covariance[j] += hidden_.covariance()[j];
  }
}

void PersonUncertainty::state(const SearchedImage& image, const PersonDoubts& doubts, TrackedBody& body) {
  humanmodel::SkeletonFrame& frame = body.frame;
  const SeenSegments seen = seenSegments(body.visible, body.support);
  for (std::size_t j = 0; j < humanmodel::kJointCount; ++j)
    if (!isSeen(seen, rig_->carrier[j])) frame.state[j] = humanmodel::JointState::kInferred;
  if (!states_spreads_) return;
  see(image, body, seen);
  const double is_new = std::clamp(1.0 - doubts.found_for / kConfirmed, 0.0, 1.0);
  const double is_turned = doubts.lying.lies && !doubts.facing_known ? 1.0 : 0.0;
  const double doubt_hidden = std::max({is_new, is_turned, doubtOfExplained(body.misfit.explained)});
  const double doubt_seen = std::max({is_new, is_turned, doubtOf(body.misfit)});
  std::array<double, kRigSegments> visible = body.visible;
  for (std::size_t s = 0; s < kRigSegments; ++s)
    if (!isSeen(seen, segmentAt(s))) visible[s] = 1.0;  // the free space says more than how little is seen
  const JointCovariances tracked = trackedCovariances(*rig_, image.fit.problem(),
                                                      {.residual = body.misfit.residual,
                                                       .doubt = doubt_seen,
                                                       .visible = visible,
                                                       .gap = body.gap,
                                                       .support = body.support});
  JointCovariances covariance = tracked;
  addTerms(doubts, body, seen, covariance);
  attachHidden(frame, tracked, alternatives_.distance(), covariance);
  const humanmodel::SkeletonFrame other = doubts.facing_known ? frame : flippedFacing(frame);
  frame.covariance = std::move(memory_);  // all are written below
  for (std::size_t j = 0; j < humanmodel::kJointCount; ++j) {
    const bool is_hidden = frame.state[j] == humanmodel::JointState::kInferred;
    const auto side = static_cast<std::size_t>(mirrored(static_cast<humanmodel::Joint>(j)));
    // A joint that is seen may be the other one, which is not.
    if (!doubts.facing_known && !is_hidden && frame.state[side] == humanmodel::JointState::kInferred)
      covariance[j] = humanmodel::enclosingCovariance(covariance[j], covariance[side]);
    const Matrix3d both = humanmodel::sumWithOffset(covariance[j], other.p[j] - frame.p[j]);
    humanmodel::setCovariance(frame, static_cast<humanmodel::Joint>(j),
                              rounded(both, is_hidden ? doubt_hidden : doubt_seen));
  }
}

void PersonUncertainty::forget() {
  motion_.forget();
  alternatives_.forget();
}

void PersonUncertainty::reuse(humanmodel::SkeletonFrame& frame) {
  if (frame.covariance.isStated()) memory_ = std::move(frame.covariance);
}

}  // namespace abstand::tracking
