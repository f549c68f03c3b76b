#include "tracking/tracker/hidden_spread.hpp"

#include <algorithm>

#include "humanmodel/part_uncertainty.hpp"

namespace abstand::tracking {
namespace {

bool has(SeenSegments seen, std::size_t s) { return (seen >> s & 1u) != 0; }

}  // namespace

std::array<double, humanmodel::kJointCount> hiddenWays(const BodyRig& rig, SeenSegments seen) {
  // Attachment point of a segment to what is visible, and the path length (m) from there.
  struct Hold {
    Vector3d p_S{Vector3d::Zero()};
    double way{kInfinity};
  };
  const auto along = [](const Hold& hold, const Vector3d& p_S) { return hold.way + (p_S - hold.p_S).norm(); };
  std::array<Hold, kRigSegments> hold;
  // From the leaves to the root, which may depend on a visible child; then from the root to the leaves.
  for (std::size_t s = kRigSegments; s-- > 1;) {
    const std::size_t parent = index(rig.parts[s].parent);
    const double way = has(seen, s) ? 0.0 : along(hold[s], Vector3d::Zero());
    if (way < hold[parent].way) hold[parent] = {rig.parts[s].p_parent, way};
  }
  for (std::size_t s = 1; s < kRigSegments; ++s) {
    const std::size_t parent = index(rig.parts[s].parent);
    const double way = has(seen, parent) ? 0.0 : along(hold[parent], rig.parts[s].p_parent);
    if (way < hold[s].way) hold[s] = {Vector3d::Zero(), way};
  }
  std::array<double, humanmodel::kJointCount> ways;
  for (std::size_t j = 0; j < humanmodel::kJointCount; ++j) {
    const std::size_t s = index(rig.carrier[j]);
    ways[j] = has(seen, s) ? 0.0 : along(hold[s], rig.p_joint[j]);
  }
  return ways;
}

void HiddenSpread::see(double t, SeenSegments seen) {
  const auto ways = hiddenWays(*rig_, seen);
  for (std::size_t s = 0; s < kRigSegments; ++s)
    if (has(seen, s)) last_seen_[s] = t;
  for (std::size_t j = 0; j < humanmodel::kJointCount; ++j) {
    const std::size_t s = index(rig_->carrier[j]);
    if (has(seen, s)) {
      spread_[j] = 0.0;
      continue;
    }
    const double moved = kMin + (t - last_seen_[s]) * humanmodel::kPersonSpeed / humanmodel::kSpreadQuantile;
    spread_[j] = std::max(kMin, std::min(moved, 2.0 * ways[j] / humanmodel::kSpreadQuantile));
  }
}

}  // namespace abstand::tracking
