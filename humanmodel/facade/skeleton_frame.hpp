// Converts between public and canonical skeletons.
#pragma once

#include "abstand/skeleton.hpp"
#include "humanmodel/joints.hpp"

namespace abstand::facade {

humanmodel::SkeletonFrame frameOf(const Skeleton& skeleton);
Skeleton skeletonOf(const humanmodel::SkeletonFrame& frame);

}  // namespace abstand::facade
