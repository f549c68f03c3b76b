#include "tracking/tracker/hidden_spread.hpp"

#include <algorithm>

#include "humanmodel/part_uncertainty.hpp"

namespace abstand::tracking {
namespace {}  // namespace

std::array<double, humanmodel::kJointCount> hiddenPathLengths(const BodyRig& rig, SeenSegments seen) {
  // Attachment point of a segment to what is visible, and the path length (m) from there.
  struct Anchor {
    Vector3d p_S{Vector3d::Zero()};
    double length{kInfinity};
  };
  const auto lengthTo = [](const Anchor& anchor, const Vector3d& p_S) {
    return anchor.length + (p_S - anchor.p_S).norm();
  };
  std::array<Anchor, kRigSegments> anchors;
  // From the leaves to the root, which may depend on a visible child; then from the root to the leaves.
  for (std::size_t s = kRigSegments; s-- > 1;) {
    const std::size_t parent = index(rig.parts[s].parent);
    const double length = isSeen(seen, segmentAt(s)) ? 0.0 : lengthTo(anchors[s], Vector3d::Zero());
    if (length < anchors[parent].length) anchors[parent] = {rig.parts[s].p_parent, length};
  }
  for (std::size_t s = 1; s < kRigSegments; ++s) {
    const std::size_t parent = index(rig.parts[s].parent);
    const double length =
        isSeen(seen, segmentAt(parent)) ? 0.0 : lengthTo(anchors[parent], rig.parts[s].p_parent);
    if (length < anchors[s].length) anchors[s] = {Vector3d::Zero(), length};
  }
  std::array<double, humanmodel::kJointCount> lengths;
  for (std::size_t j = 0; j < humanmodel::kJointCount; ++j) {
    const std::size_t s = index(rig.carrier[j]);
    lengths[j] = isSeen(seen, segmentAt(s)) ? 0.0 : lengthTo(anchors[s], rig.p_joint[j]);
  }
  return lengths;
}

void HiddenSpread::see(double t, SeenSegments seen, const Extents& extent, const JointCovariances& shape) {
  const auto lengths = hiddenPathLengths(*rig_, seen);
  for (std::size_t s = 0; s < kRigSegments; ++s)
    if (isSeen(seen, segmentAt(s))) last_seen_[s] = t;
  for (std::size_t j = 0; j < humanmodel::kJointCount; ++j) {
    const std::size_t s = index(rig_->carrier[j]);
    covariance_[j].setZero();
    spread_[j] = 0.0;
    if (isSeen(seen, segmentAt(s))) continue;
    const double moved = kMin + (t - last_seen_[s]) * humanmodel::kPersonSpeed;
    const double bound = std::min(moved, 2.0 * lengths[j]);
    spread_[j] = std::max(kMin, std::min(bound, extent[j])) / humanmodel::kSpreadQuantile;
    if (extent[j] < bound && extent[j] > kMin)
      covariance_[j] = shape[j] / (humanmodel::kSpreadQuantile * humanmodel::kSpreadQuantile);
    else
      covariance_[j].diagonal().setConstant(spread_[j] * spread_[j]);
  }
}

}  // namespace abstand::tracking
