// Measured people as a body plan.
#include <algorithm>

#include "core/math/transform.hpp"
#include "humanmodel/anthropometry.hpp"
#include "humanmodel/body_plan.hpp"

namespace abstand::humanmodel {
namespace {

using enum PartShape;

// Shares of the largest girth that arms and legs keep at their joints. 0.6 of a forearm or calf is a wrist
// (0.57, ANSUR II) or an ankle; two ellipsoids that meet with 0.6 of their girth also cover most of an elbow
// or knee. A thigh is thick right up to the hip, and the torso hides the rest.
constexpr double kJointShare = 0.6, kHipShare = 0.8;
// The upper arm must not stand far above the shoulder.
constexpr double kShoulderShare = 0.5;
// A hand ends nearly in a point: its longest finger.
constexpr double kFingerShare = 0.3;

// Shares of stature.
constexpr double kHeelBehindAnkle = .04, kToeHeight = .010, kFootHeight = .042;
constexpr double kShoulderReach = .020;

Segment roundSegment(double length, double girth, double proximal_share, double distal_share) {
  return {kEllipsoid, length, girth / kPi, girth / kPi, proximal_share, distal_share};
}

}  // namespace

BodyPlan anthropometricPlan(double height, double mass, std::optional<Sex> sex) {
  const BodyMeasures m = measuresOf(height, mass, sex);
  BodyPlan plan;

  // One cuboid round chest, waist and hips, from the crotch to the seventh cervical vertebra.
  const double torso_length = m.cervicale_height - m.crotch_height;
  plan[PartKind::kTorso] = {kCuboid, torso_length,
                            std::max({m.chest_breadth, m.waist_breadth, m.hip_breadth}),
                            std::max({m.chest_depth, m.waist_depth, m.buttock_depth})};

  // Measured breadth and depth of the head give the ratio, its girth the size.
  const double head_scale = m.head_girth / contourOf(kEllipsoid, m.head_breadth, m.head_depth);
  plan[PartKind::kHead] = {
      kEllipsoid, height - m.cervicale_height, m.head_breadth * head_scale, m.head_depth * head_scale,
      0.0,        m.neck_girth / m.head_girth};

  plan[PartKind::kBiceps] = roundSegment(m.acromion_radiale, m.biceps_girth, kShoulderShare, kJointShare);
  plan[PartKind::kForearm] = roundSegment(m.radiale_stylion, m.forearm_girth, kJointShare, kJointShare);
  plan[PartKind::kThigh] = roundSegment(m.trochanter_epicondyle, m.thigh_girth, kHipShare, kJointShare);
  plan[PartKind::kCalf] = roundSegment(m.epicondyle_malleolus, m.calf_girth, kJointShare, kJointShare);

  // The palm of a hanging arm faces the thigh: its breadth lies along x.
  plan[PartKind::kHand] = {kEllipsoid,     m.hand_length, extentFor(kEllipsoid, m.hand_girth, m.hand_breadth),
                           m.hand_breadth, kJointShare,   kFingerShare};
  plan[PartKind::kFoot] = {kCuboid, m.foot_length, m.foot_breadth, height * kFootHeight};

  // Joints at the landmarks: the hip at the trochanter, shoulders at the acromion, the rest as lengths
  // follow.
  const double hip_height = m.acromial_height - m.acromion_trochanter;
  plan.ankle_height = hip_height - m.trochanter_epicondyle - m.epicondyle_malleolus;
  plan.toe_height = height * kToeHeight;
  plan.heel_share = height * kHeelBehindAnkle / m.foot_length;
  plan.hip_share = (hip_height - m.crotch_height) / torso_length;
  plan.shoulder_share = (m.acromial_height - m.crotch_height) / torso_length;
  plan.shoulder_half = 0.5 * m.biacromial_breadth;
  plan.shoulder_reach = height * kShoulderReach;
  return plan;
}

}  // namespace abstand::humanmodel
