// Where the joints lie: in the parts, and in a person who stands.
#pragma once

#include "humanmodel/body_plan.hpp"

namespace abstand::humanmodel {

/// Body plan with every part's own segment, overrides included.
struct BuiltBody {
  BodyPlan plan;
  std::array<Segment, kBodyPartCount> segments;
  const Segment& operator[](BodyPart part) const { return segments[index(part)]; }
};

/// Shape, length, contour and joint positions of one part; no mass yet.
HumanPart makePart(const BuiltBody& body, BodyPart part);

/// Joints of the standing person. With legs of different length the longer one stands on the floor.
SkeletonFrame restPose(const BuiltBody& body, const std::vector<HumanPart>& parts);

}  // namespace abstand::humanmodel
