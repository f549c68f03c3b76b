// Body plan from anthropometric data.
#include <algorithm>

#include "core/math/transform.hpp"
#include "humanmodel/anthropometry.hpp"
#include "humanmodel/body_plan.hpp"
#include "humanmodel/girth_spread.hpp"

namespace abstand::humanmodel {
namespace {

using enum PartShape;

// Share of the largest girth at the joints of arms and legs. 0.6 of a forearm or calf is a wrist (0.57, ANSUR
// II) or an ankle; two adjacent ellipsoids with 0.6 of their girth also cover most of an elbow or knee. A
// thigh keeps its girth up to the hip, inside of the torso.
constexpr double kJointShare = 0.6, kHipShare = 0.8;
// The upper arm must not extend far above the shoulder.
constexpr double kShoulderShare = 0.5;
// A hand nearly ends in a point, the longest finger.
constexpr double kFingerShare = 0.3;

// Shares of stature.
constexpr double kHeelBehindAnkle = .04, kToeHeight = .010;
constexpr double kShoulderReach = .020;

Segment limb(double length, const Section& section, double proximal_share, double distal_share) {
  return {kEllipsoid, length, section.breadth, section.depth, proximal_share, distal_share};
}

}  // namespace

BodyPlan anthropometricPlan(double height, std::optional<double> mass, std::optional<Sex> sex,
                            std::optional<double> percentile) {
  using enum GirthPlace;
  const BodyMeasures m = measuresOf(height, mass ? *mass : meanBodyMassIndex(sex) * (height * height), sex);
  const BodySections s =
      percentile ? sectionsOfPercentile(*percentile, height, mass, sex) : meanSections(height, mass, sex);
  BodyPlan plan;

  // One cuboid around chest, waist and hips, from the crotch to the seventh cervical vertebra.
  const double torso_length = m.cervicale_height - m.crotch_height;
  plan[PartKind::kTorso] = {kCuboid, torso_length,
                            std::max({s[kChest].breadth, s[kWaist].breadth, s[kButtock].breadth}),
                            std::max({s[kChest].depth, s[kWaist].depth, s[kButtock].depth})};

  plan[PartKind::kHead] = limb(height - m.cervicale_height, s[kHead], 0.0, s[kNeck].girth / s[kHead].girth);

  plan[PartKind::kBiceps] = limb(m.acromion_radiale, s[kBiceps], kShoulderShare, kJointShare);
  plan[PartKind::kForearm] = limb(m.radiale_stylion, s[kForearm], kJointShare, kJointShare);
  plan[PartKind::kThigh] = limb(m.trochanter_epicondyle, s[kThigh], kHipShare, kJointShare);
  plan[PartKind::kCalf] = limb(m.epicondyle_malleolus, s[kCalf], kJointShare, kJointShare);

  plan[PartKind::kHand] = limb(m.hand_length, s[kHand], kJointShare, kFingerShare);
  plan[PartKind::kFoot] = {kCuboid, m.foot_length, s[kFoot].breadth, s[kFoot].depth};

  // Joints at landmarks: hip at the trochanter, shoulder at the acromion; the others follow from lengths.
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
