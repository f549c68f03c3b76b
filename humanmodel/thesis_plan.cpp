// The thesis's proportions (Table B.1) as a body plan.
#include "core/math/transform.hpp"
#include "humanmodel/body_plan.hpp"

namespace abstand::humanmodel {
namespace {

/// One row of the table, as shares of stature.
struct Row {
  PartKind kind;
  PartShape shape;
  double length, contour;
  double depth_to_breadth;  ///< not in the table
};

// The printed table exchanges the lengths of torso and head: 0.16 h is a head with its neck (ANSUR II 0.136
// to 0.143), 0.34 h a trunk, and only then do the lengths add up to the stature. The torso cuboid is three
// quarters as deep as broad, as waists are; the foot cuboid has the height of an ankle and the breadth of a
// foot (Drillis and Contini 1966).
using enum PartShape;
constexpr double kRound = 1.0;
constexpr Row kTable[] = {
    {PartKind::kTorso, kCuboid, .34, .67, .75},        {PartKind::kHead, kEllipsoid, .16, .36, kRound},
    {PartKind::kBiceps, kEllipsoid, .19, .24, kRound}, {PartKind::kForearm, kEllipsoid, .15, .20, kRound},
    {PartKind::kHand, kEllipsoid, .11, .11, kRound},   {PartKind::kThigh, kEllipsoid, .25, .37, kRound},
    {PartKind::kCalf, kEllipsoid, .22, .24, kRound},   {PartKind::kFoot, kCuboid, .15, .20, .039 / .055},
};

// Drillis and Contini 1966, in Winter 2009, figure 4.1: shares of stature.
constexpr double kAnkleHeight = .039, kShoulderHeight = .818;
// Half the biacromial breadth of ANSUR II, mean of men and women.
constexpr double kShoulderHalf = .115;
// The table's torso is narrower than shoulders, and its upper arms end in points: farther out they would not
// touch the torso.
constexpr double kThesisShoulderReach = .010;
constexpr double kThesisHeelBehindAnkle = .04;
constexpr double kThesisToeHeight = .010;

}  // namespace

BodyPlan thesisPlan(double height) {
  BodyPlan plan;
  for (const Row& row : kTable) {
    Segment& s = plan[row.kind];
    s.shape = row.shape;
    s.length = height * row.length;
    const double contour = height * row.contour;
    s.breadth = row.shape == kCuboid ? 0.5 * contour / (1.0 + row.depth_to_breadth) : contour / kPi;
    s.depth = s.breadth * row.depth_to_breadth;
  }
  // The table's legs extend from the ankle to 0.509 h, its torso and head from the top down to 0.5 h. The
  // thigh ends in a point at the hip, which leaves a gap; a joint where the thigh has 0.8 of its girth would
  // be at 0.459 h, below the trunk, and the knee of a seated person 0.05 h too near.
  const double torso = plan[PartKind::kTorso].length,
               torso_bottom = height - plan[PartKind::kHead].length - torso;
  plan.ankle_height = height * kAnkleHeight;
  plan.toe_height = height * kThesisToeHeight;
  plan.heel_share = height * kThesisHeelBehindAnkle / plan[PartKind::kFoot].length;
  const double hip_height = plan.ankle_height + plan[PartKind::kCalf].length + plan[PartKind::kThigh].length;
  plan.hip_share = (hip_height - torso_bottom) / torso;
  plan.shoulder_share = (height * kShoulderHeight - torso_bottom) / torso;
  plan.shoulder_half = height * kShoulderHalf;
  plan.shoulder_reach = height * kThesisShoulderReach;
  return plan;
}

}  // namespace abstand::humanmodel
