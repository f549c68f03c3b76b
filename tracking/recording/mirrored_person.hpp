// Mirrors a recording of a person: left and right exchanged.
#pragma once

#include <vector>

#include "humanmodel/joints.hpp"

namespace abstand::tracking {

/// Reflects the joints in the vertical plane through the mean hip position, perpendicular to the mean line
/// from hip to hip (from shoulder to shoulder if no hip was recorded), and exchanges joints of the left and
/// right side. The person stays in place and faces the same way. Throws UsageError if neither hips nor
/// shoulders were recorded, or their line has no horizontal direction.
void mirrorPerson(std::vector<humanmodel::SkeletonFrame>& frames);

}  // namespace abstand::tracking
