// A recording of a person with left and right exchanged.
#pragma once

#include <vector>

#include "humanmodel/joints.hpp"

namespace abstand::tracking {

/// Makes the person who does the same with the other hand: joints are reflected in the vertical plane through
/// the mean place of the hips, across the mean line from one hip to the other (of the shoulders where no hip
/// was recorded), and those of the left side become those of the right one. The person stays where they were
/// and faces the same way. Throws UsageError where neither hips nor shoulders were recorded, or they lie
/// across no horizontal direction.
void mirrorPerson(std::vector<humanmodel::SkeletonFrame>& frames);

}  // namespace abstand::tracking
