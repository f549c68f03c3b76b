// Shapes with their joints, and the standing pose.
#include "humanmodel/rest_pose.hpp"

#include <algorithm>
#include <cmath>

namespace abstand::humanmodel {
namespace {

using enum Joint;
constexpr std::array<std::pair<Joint, Joint>, kBodyPartCount> kJointsOfPart{{{kNeck, kPelvis},
                                                                             {kHeadTop, kNeck},
                                                                             {kShoulderLeft, kElbowLeft},
                                                                             {kShoulderRight, kElbowRight},
                                                                             {kElbowLeft, kWristLeft},
                                                                             {kElbowRight, kWristRight},
                                                                             {kWristLeft, kHandLeft},
                                                                             {kWristRight, kHandRight},
                                                                             {kHipLeft, kKneeLeft},
                                                                             {kHipRight, kKneeRight},
                                                                             {kKneeLeft, kAnkleLeft},
                                                                             {kKneeRight, kAnkleRight},
                                                                             {kAnkleLeft, kToeLeft},
                                                                             {kAnkleRight, kToeRight}}};

// The centre of a head is half a head (chin to vertex 0.130 h of 0.14 h with the neck; Drillis and Contini
// 1966) below the vertex.
constexpr double kHeadMiddleShare = 0.46;

/// Share of an ellipsoid's semi-axis at which its girth is `share` of the largest.
double axisShare(double share) { return std::sqrt((1.0 - share) * (1.0 + share)); }

/// Half extent along z, and z of both joints, for all parts except feet.
struct AxialLayout {
  double half, z_proximal, z_distal;
};

AxialLayout layoutOf(const BuiltBody& body, BodyPart part) {
  const Segment& s = body[part];
  if (part == BodyPart::kTorso) {
    const double half = 0.5 * s.length;
    return {half, half, body.plan.hip_share * s.length - half};
  }
  if (s.shape == PartShape::kCuboid) return {0.5 * s.length, 0.5 * s.length, -0.5 * s.length};
  const double up = axisShare(s.proximal_share), down = axisShare(s.distal_share);
  const double half = s.length / (up + down);
  return {half, half * up, -half * down};
}

}  // namespace

HumanPart makePart(const BuiltBody& body, BodyPart part) {
  const Segment& s = body[part];
  HumanPart made;
  made.part = part;
  made.length = s.length;
  made.breadth = s.breadth;
  made.depth = s.depth;
  made.contour = contourOf(s.shape, s.breadth, s.depth);
  std::tie(made.proximal, made.distal) = kJointsOfPart[index(part)];

  Vector3d size;
  if (kindOf(part) == PartKind::kFoot) {
    size = {s.length, s.breadth, s.depth};
    const double heel_to_ankle = body.plan.heel_share * s.length;
    made.p_proximal = {heel_to_ankle - 0.5 * s.length, 0.0, body.plan.ankle_height - 0.5 * s.depth};
    made.p_distal = {0.5 * s.length, 0.0, body.plan.toe_height - 0.5 * s.depth};
  } else {
    const AxialLayout axis = layoutOf(body, part);
    size = {s.depth, s.breadth, 2.0 * axis.half};
    made.p_proximal = {0.0, 0.0, axis.z_proximal};
    made.p_distal = {0.0, 0.0, axis.z_distal};
  }
  if (s.shape == PartShape::kCuboid)
    made.shape = geometry::Cuboid{size};
  else
    made.shape = geometry::Ellipsoid{0.5 * size};
  return made;
}

SkeletonFrame restPose(const BuiltBody& body, const std::vector<HumanPart>& parts) {
  const auto drop = [&](BodyPart part) {
    const HumanPart& p = parts[index(part)];
    return p.p_distal - p.p_proximal;
  };
  const Segment& torso = body[BodyPart::kTorso];
  const double half_torso = 0.5 * torso.breadth;

  // The longer leg is on the floor.
  const double left_leg = body[BodyPart::kThighLeft].length + body[BodyPart::kCalfLeft].length;
  const double right_leg = body[BodyPart::kThighRight].length + body[BodyPart::kCalfRight].length;
  const Vector3d p_pelvis{0.0, 0.0, body.plan.ankle_height + std::max(left_leg, right_leg)};
  const Vector3d p_neck = p_pelvis - drop(BodyPart::kTorso);
  const Vector3d p_top = p_neck - drop(BodyPart::kHead);
  const Vector3d p_shoulders =
      p_pelvis + Vector3d::UnitZ() * torso.length * (body.plan.shoulder_share - body.plan.hip_share);

  SkeletonFrame rest;
  rest.set(kPelvis, p_pelvis);
  rest.set(kSpine, 0.5 * (p_pelvis + p_neck));
  rest.set(kThorax, p_shoulders);
  rest.set(kNeck, p_neck);
  rest.set(kHead, p_top + kHeadMiddleShare * (p_neck - p_top));
  rest.set(kHeadTop, p_top);

  const double shoulder =
      std::clamp(body.plan.shoulder_half, half_torso, half_torso + body.plan.shoulder_reach);
  const auto hang = [&](BodyPart part) {
    const HumanPart& p = parts[index(part)];
    rest.set(p.distal, rest[p.proximal] + drop(part));
  };
  for (const int side : {1, -1}) {
    const auto on_side = [side](BodyPart left) {
      return static_cast<BodyPart>(index(left) + (side > 0 ? 0u : 1u));
    };
    // The thighs of a standing person just touch.
    const double hip = std::min(0.5 * body[on_side(BodyPart::kThighLeft)].breadth, half_torso);
    rest.set(parts[index(on_side(BodyPart::kBicepsLeft))].proximal,
             p_shoulders + side * shoulder * Vector3d::UnitY());
    rest.set(parts[index(on_side(BodyPart::kThighLeft))].proximal, p_pelvis + side * hip * Vector3d::UnitY());
    for (const BodyPart left : {BodyPart::kBicepsLeft, BodyPart::kForearmLeft, BodyPart::kHandLeft,
                                BodyPart::kThighLeft, BodyPart::kCalfLeft, BodyPart::kFootLeft})
      hang(on_side(left));
  }
  return rest;
}

}  // namespace abstand::humanmodel
