// Initial poses of people who squat or bend to the floor.
#pragma once

#include "tracking/body/body_rig.hpp"
#include "tracking/tracker/body_view.hpp"

namespace abstand::tracking {

inline constexpr std::size_t kBentStarts = 5;

/// On both feet, the arms hanging, the trunk bent in pelvis and chest, so that the back is the highest point
/// of the body. Towards either end of the longest horizontal extent of the points, which passes `middle` (m,
/// world); the highest one is at z = `top` (m). The last one squats facing `facing` (rad, world): of somebody
/// behind a bench, the longest extent is that of both arms. No allocation, no throw.
void bentStarts(const BodyRig& rig, const SeenPoints& points, const Vector3d& middle, double top,
                double facing, std::array<RigPose, kBentStarts>& starts);

}  // namespace abstand::tracking
