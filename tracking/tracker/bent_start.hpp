// Initial poses of people who squat or bend to the floor.
#pragma once

#include "tracking/body/body_rig.hpp"
#include "tracking/tracker/body_view.hpp"

namespace abstand::tracking {

inline constexpr std::size_t kBentStarts = 4;

/// On both feet, the arms hanging, the trunk bent in pelvis and chest, so that the back is the highest point
/// of the body. Towards either end of the longest horizontal extent of the points, which passes `middle` (m,
/// world); the highest one is at z = `top` (m). No allocation, no throw.
void bentStarts(const BodyRig& rig, const SeenPoints& points, const Vector3d& middle, double top,
                std::array<RigPose, kBentStarts>& starts);

}  // namespace abstand::tracking
