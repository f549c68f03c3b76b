// Extents, bent arms, comparison of costs.
#include "tracking/tracker/lying_start.hpp"

#include <algorithm>
#include <cmath>

#include "tracking/tracker/longest_extent.hpp"
#include "tracking/tracker/raised_arms.hpp"
#include "tracking/tracker/turned_round.hpp"

namespace abstand::tracking {
namespace {

constexpr double kLyingPelvis = 0.12;  // m, height
constexpr double kBesideHead = 0.20;   // m, of wrists above the shoulders: hands beside the head
// rad; feet of people who lie on the front are stretched, as the floor leaves them no other way.
constexpr double kStretchedFoot = 0.9;
// times the smaller cost: beyond, lying on the back and on the front are told apart, as facings are
// (Facing::kSureLying); and so are poses on the same side. The true pose cost up to 1.62 times as much as
// one with the arms 0.7 m off.
constexpr double kSidesAlike = 1.15, kPosesAlike = 1.75;
// m, depth of a forearm's surface in the trunk: an upper arm that ends there goes through the trunk, and the
// forearm stands for what it should explain. Arms that lie against the trunk are up to 0.03 inside. Share of
// the cost that each such arm adds.
constexpr double kThroughTrunk = 0.05, kThrough = 0.25;

}  // namespace

double vertexAbovePelvis(const BodyRig& rig) {
  RigPlacement X_WS;
  place(rig, RigPose{}, X_WS);
  return jointPosition(rig, X_WS, humanmodel::Joint::kHeadTop).z();
}

void lyingStarts(const BodyRig& rig, const SeenPoints& points, const Vector3d& middle,
                 std::array<LyingStart, kLyingStarts>& starts) {
  const double angle = longestExtent(points, middle);
  std::size_t k = 0;
  for (const double end : {0.0, kPi}) {
    const Vector3d head(std::cos(angle + end), std::sin(angle + end), 0.0);
    double farthest = -kInfinity;
    for (std::size_t i = 0; i < points.count; ++i)
      farthest = std::max(farthest, head.dot(points.point(i) - middle));
    for (const bool on_front : {false, true}) {
      RigPose pose;
      const Vector3d x = (on_front ? -1.0 : 1.0) * Vector3d::UnitZ();
      pose.X_WP.linear() << x, head.cross(x), head;
      pose.X_WP.translation() = middle + (farthest - vertexAbovePelvis(rig)) * head;
      pose.X_WP.translation().z() = kLyingPelvis;
      if (on_front)
        for (const Limb& leg : {kLimbs[2], kLimbs[3]}) pose.angle[index(leg.end)][0] = kStretchedFoot;
      starts[k++] = {pose, on_front};
      raiseArms(rig, kBesideHead, pose);
      starts[k++] = {pose, on_front};
    }
  }
}

bool LyingFits::add(double cost, const RigPlacement& X_WS, const std::array<double, kRigSegments>& gap,
                    bool on_front) {
  Fit& fit = fits_[count_];
  double through = 0.0;
  for (const RigSegment forearm : {RigSegment::kForearmLeft, RigSegment::kForearmRight})
    through += gap[index(forearm)] < -kThroughTrunk ? 1.0 : 0.0;
  fit.cost = cost;
  fit.rank = cost * (1.0 + kThrough * through);
  fit.on_front = on_front;
  jointsOf(*rig_, X_WS, humanmodel::JointState::kTracked, fit.frame);
  const std::size_t side = on_front ? 1 : 0;
  const bool is_best = !std::isfinite(least_[side]) || fit.rank < fits_[best_[side]].rank;
  if (is_best) best_[side] = count_;
  least_[side] = std::min(least_[side], cost);
  ++count_;
  return is_best;
}

bool LyingFits::onFront() const { return least_[1] < least_[0]; }

double LyingFits::frontOverBack() const {
  return std::isfinite(least_[0]) && std::isfinite(least_[1]) ? least_[1] / least_[0] : kNaN;
}

bool LyingFits::sidesAlike() const {
  const double ratio = frontOverBack();
  return ratio <= kSidesAlike && ratio >= 1.0 / kSidesAlike;
}

JointRadii LyingFits::apart() const {
  JointRadii apart{};
  if (count_ == 0) return apart;
  const Fit& best = fits_[best_[onFront() ? 1 : 0]];
  const bool alike = sidesAlike();
  const humanmodel::SkeletonFrame turned = flippedFacing(best.frame);
  for (const Fit& fit : std::span(fits_).first(count_)) {
    const bool same_side = fit.on_front == best.on_front;
    if (fit.cost > kPosesAlike * best.cost || (!same_side && !alike)) continue;
    const humanmodel::SkeletonFrame& from = same_side ? best.frame : turned;
    for (std::size_t j = 0; j < humanmodel::kJointCount; ++j)
      apart[j] = std::max(apart[j], (fit.frame.p[j] - from.p[j]).norm());
  }
  return apart;
}

}  // namespace abstand::tracking
