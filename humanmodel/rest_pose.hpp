// Joint positions: in the parts, and in the standing pose.
#pragma once

#include "humanmodel/body_plan.hpp"

namespace abstand::humanmodel {

/// Body plan with the segment of every part, overrides included.
struct BuiltBody {
  BodyPlan plan;
  std::array<Segment, kBodyPartCount> segments;
  const Segment& operator[](BodyPart part) const { return segments[index(part)]; }
};

/// Shape, length, girth and joint positions of one part; without mass.
HumanPart makePart(const BuiltBody& body, BodyPart part);

/// Joints in the standing pose. With legs of different length the longer one is on the floor.
SkeletonFrame restPose(const BuiltBody& body, const std::vector<HumanPart>& parts);

}  // namespace abstand::humanmodel
