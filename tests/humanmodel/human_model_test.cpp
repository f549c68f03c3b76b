// The fourteen parts: sizes, masses, joints, limits.
#include "humanmodel/human_model.hpp"

#include <gtest/gtest.h>
#include <Eigen/Eigenvalues>

#include <cmath>

#include "core/base/error.hpp"
#include "core/geometry/surface.hpp"
#include "humanmodel/anthropometry.hpp"

namespace abstand::humanmodel {
namespace human_model_test {

constexpr double kRounding = 1e-12;
// Table B.1 is exact; this is what its users compare with.
constexpr double kTable = 1e-9;
// Lines in stature and body mass against percentiles of single measures: they are no one person's measures.
constexpr double kPercentile = 0.04;

HumanModel human(double height, HumanPreset preset = HumanPreset::kAnthropometric,
                 std::optional<double> mass = {}, std::optional<Sex> sex = {}) {
  HumanOptions options;
  options.height = height;
  options.mass = mass;
  options.sex = sex;
  options.preset = preset;
  return makeHuman(options);
}

std::vector<HumanModel> variety() {
  std::vector<HumanModel> people;
  for (const double h : {0.5, 1.1, 1.525, 1.75, 1.87, 2.5})
    for (const HumanPreset preset : {HumanPreset::kThesis, HumanPreset::kAnthropometric})
      for (const std::optional<Sex> sex : {std::optional<Sex>{}, {Sex::kFemale}, {Sex::kMale}})
        people.push_back(human(h, preset, {}, sex));
  for (const double bmi : {14.0, 45.0})
    people.push_back(human(1.75, HumanPreset::kAnthropometric, bmi * 1.75 * 1.75));
  return people;
}

Vector3d halfExtents(const geometry::Shape& shape) {
  if (const auto* e = std::get_if<geometry::Ellipsoid>(&shape)) return e->semi_axes;
  return 0.5 * std::get<geometry::Cuboid>(shape).size;
}

bool contains(const geometry::Shape& shape, const Vector3d& p) {
  const Vector3d scaled = p.cwiseQuotient(halfExtents(shape));
  return std::holds_alternative<geometry::Ellipsoid>(shape) ? scaled.squaredNorm() <= 1.0
                                                            : scaled.cwiseAbs().maxCoeff() <= 1.0;
}

/// Frame of a part in the rest pose, where it has the world's axes.
Vector3d restOrigin(const HumanModel& m, const HumanPart& p) { return m.rest[p.proximal] - p.p_proximal; }

/// An upper bound of the distance between two shapes near the point p_W, by walking from one to the other's
/// points.
double gapNear(const HumanModel& m, const HumanPart& a, const HumanPart& b, const Vector3d& p_W) {
  constexpr double kReach = 0.15;
  constexpr int kSteps = 31;
  std::vector<Vector3d> in_a, in_b;
  for (int i = 0; i < kSteps; ++i)
    for (int j = 0; j < kSteps; ++j)
      for (int k = 0; k < kSteps; ++k) {
        const Vector3d q = p_W + kReach * (2.0 * Vector3d(i, j, k) / (kSteps - 1) - Vector3d::Ones());
        const bool with_a = contains(a.shape, q - restOrigin(m, a)),
                   with_b = contains(b.shape, q - restOrigin(m, b));
        if (with_a && with_b) return 0.0;
        if (with_a) in_a.push_back(q);
        if (with_b) in_b.push_back(q);
      }
  // The poles of shapes that end in points fall between samples.
  for (const HumanPart* part : {&a, &b})
    for (const Vector3d& pole : {part->p_proximal, part->p_distal})
      if (contains(part->shape, pole * (1.0 - kRounding)))
        (part == &a ? in_a : in_b).push_back(restOrigin(m, *part) + pole);
  double nearest = kInfinity;
  for (const Vector3d& p : in_a)
    for (const Vector3d& q : in_b) nearest = std::min(nearest, (p - q).norm());
  return nearest;
}

TEST(HumanModel, ThesisPresetMatchesCorrectedTable) {
  struct Row {
    PartKind kind;
    bool cuboid;
    double length, contour;
  };
  const Row table[] = {{PartKind::kTorso, true, .34, .67},   {PartKind::kHead, false, .16, .36},
                       {PartKind::kBiceps, false, .19, .24}, {PartKind::kForearm, false, .15, .20},
                       {PartKind::kHand, false, .11, .11},   {PartKind::kThigh, false, .25, .37},
                       {PartKind::kCalf, false, .22, .24},   {PartKind::kFoot, true, .15, .20}};
  for (const double h : {1.5, 1.8, 2.0}) {
    const HumanModel m = human(h, HumanPreset::kThesis);
    ASSERT_EQ(m.parts.size(), kBodyPartCount);
    for (const HumanPart& p : m.parts) {
      const Row& row = table[index(kindOf(p.part))];
      ASSERT_EQ(row.kind, kindOf(p.part));
      EXPECT_EQ(std::holds_alternative<geometry::Cuboid>(p.shape), row.cuboid) << partName(p.part);
      EXPECT_NEAR(p.length, row.length * h, kTable) << partName(p.part);
      EXPECT_NEAR(p.contour, row.contour * h, kTable) << partName(p.part);
      const Vector3d half = halfExtents(p.shape);
      const bool foot = row.kind == PartKind::kFoot;
      EXPECT_NEAR(2.0 * half[foot ? 0 : 2], row.length * h, kTable) << partName(p.part);
      if (row.cuboid)
        EXPECT_NEAR(4.0 * (half.y() + half[foot ? 2 : 0]), row.contour * h, kTable) << partName(p.part);
      else
        EXPECT_NEAR(2.0 * kPi * half.y(), row.contour * h, kTable) << partName(p.part);
    }
  }
}

TEST(HumanModel, NamesAndNeighboursAreConsistent) {
  for (std::size_t i = 0; i < kBodyPartCount; ++i) {
    const auto part = static_cast<BodyPart>(i);
    EXPECT_EQ(parsePart(partName(part)), part);
    EXPECT_EQ(sideOf(part), partName(part).ends_with("_left")    ? 1
                            : partName(part).ends_with("_right") ? -1
                                                                 : 0);
  }
  EXPECT_FALSE(parsePart("tail"));
  EXPECT_FALSE(parsePart(""));
  const HumanModel m = human(1.75);
  for (const auto& [parent, child] : adjacentParts()) {
    EXPECT_LT(parent, child) << "a parent is placed before its children";
    EXPECT_EQ(parentOf(child), parent);
    EXPECT_TRUE(sideOf(parent) == 0 || sideOf(parent) == sideOf(child));
  }
  EXPECT_FALSE(parentOf(BodyPart::kTorso));
}

TEST(HumanModel, MassesSumAndInertiaMatchesDeLeva) {
  for (const HumanModel& m : variety()) {
    double sum = 0.0;
    for (const HumanPart& p : m.parts) {
      sum += p.mass;
      EXPECT_TRUE(contains(p.shape, p.com)) << partName(p.part) << " " << p.com.transpose();
      EXPECT_EQ(p.inertia, p.inertia.transpose());
      const Vector3d moments = Eigen::SelfAdjointEigenSolver<Matrix3d>(p.inertia).eigenvalues();
      EXPECT_GT(moments[0], 0.0) << partName(p.part);
      EXPECT_LE(moments[2], moments[0] + moments[1]) << partName(p.part);
    }
    EXPECT_NEAR(sum, m.mass, kRounding * m.mass);
  }
  // de Leva's man of 73 kg: shares of the whole.
  const HumanModel man = human(1.741, HumanPreset::kAnthropometric, 73.0, Sex::kMale);
  EXPECT_NEAR(man.part(BodyPart::kTorso).mass, .4346 * 73.0, 0.01);
  EXPECT_NEAR(man.part(BodyPart::kFootRight).mass, .0137 * 73.0, 0.01);
  const HumanPart& thigh = man.part(BodyPart::kThighLeft);
  EXPECT_NEAR((thigh.com - thigh.p_proximal).norm(), .4095 * thigh.length, kRounding);
  EXPECT_NEAR(thigh.inertia(2, 2), thigh.mass * std::pow(.149 * thigh.length, 2), kRounding);
  // A palm that faces inwards is hardest to turn about the axis through it, y.
  const HumanPart& hand = man.part(BodyPart::kHandLeft);
  EXPECT_NEAR(hand.inertia(1, 1) / hand.inertia(0, 0), std::pow(.628 / .513, 2), kRounding);
  // A foot lies: its long axis is x.
  const HumanPart& foot = man.part(BodyPart::kFootLeft);
  EXPECT_NEAR(foot.inertia(0, 0), foot.mass * std::pow(.124 * foot.length, 2), kRounding);
}

TEST(HumanModel, StandsFromFloorToStature) {
  for (const HumanModel& m : variety()) {
    EXPECT_NEAR(m.rest[Joint::kHeadTop].z(), m.height, kRounding);
    EXPECT_EQ(m.rest[Joint::kPelvis].head<2>(), Eigen::Vector2d::Zero());
    for (std::size_t j = 0; j < kJointCount; ++j) {
      ASSERT_TRUE(m.rest.has(static_cast<Joint>(j)));
      ASSERT_TRUE(m.rest.p[j].allFinite());
    }
    double lowest = kInfinity, highest = -kInfinity;
    for (const HumanPart& p : m.parts) {
      const double z = restOrigin(m, p).z(), half = halfExtents(p.shape).z();
      lowest = std::min(lowest, z - half);
      highest = std::max(highest, z + half);
      EXPECT_LT((m.rest[p.distal] - restOrigin(m, p) - p.p_distal).norm(), kRounding) << partName(p.part);
    }
    EXPECT_NEAR(highest, m.height, kRounding);
    EXPECT_NEAR(lowest, 0.0, kRounding);
    for (const BodyPart foot : {BodyPart::kFootLeft, BodyPart::kFootRight})
      EXPECT_NEAR(restOrigin(m, m.part(foot)).z() - halfExtents(m.part(foot).shape).z(), 0.0, kRounding);
    EXPECT_GT(m.rest[Joint::kToeLeft].x(), m.rest[Joint::kAnkleLeft].x()) << "faces +x";
    EXPECT_GT(m.rest[Joint::kShoulderLeft].y(), 0.0) << "left is +y";
  }
}

TEST(HumanModel, JointHeightsMatchMeasuredPeople) {
  // Drillis and Contini 1966 in shares of stature; 0.02 is what ANSUR II landmarks differ from them.
  const std::pair<Joint, double> heights[] = {{Joint::kAnkleLeft, .039}, {Joint::kKneeLeft, .285},
                                              {Joint::kHipLeft, .530},   {Joint::kShoulderLeft, .818},
                                              {Joint::kElbowLeft, .630}, {Joint::kWristLeft, .485}};
  for (const HumanModel& m : variety()) {
    const double slack = m.options.preset == HumanPreset::kThesis ? .03 : .02;
    for (const auto& [joint, share] : heights)
      EXPECT_NEAR(m.rest[joint].z() / m.height, share, slack) << jointName(joint);
  }
}

TEST(HumanModel, NeighboursMeetAtSharedJoint) {
  constexpr double kLargestGap = 0.02;  // m
  for (const HumanModel& m : variety()) {
    if (m.height > 2.0) continue;  // gaps grow with the body
    for (const auto& [parent, child] : adjacentParts()) {
      const Joint joint = child == BodyPart::kHead ? Joint::kNeck : m.part(child).proximal;
      EXPECT_LE(gapNear(m, m.part(parent), m.part(child), m.rest[joint]), kLargestGap)
          << partName(parent) << " " << partName(child) << " at " << m.height;
    }
  }
}

/// m, how far a ball around the left hip, of 0.8 times the thigh's half thickness, extends beyond torso and
/// thigh with the hip flexed by `flexion` (rad).
double gapAtHip(const HumanModel& m, double flexion) {
  constexpr int kCircles = 24;
  const HumanPart &torso = m.part(BodyPart::kTorso), &thigh = m.part(BodyPart::kThighLeft);
  const auto of_torso = geometry::makeSurface(torso.bare), of_thigh = geometry::makeSurface(thigh.bare);
  const Matrix3d R_PW = Eigen::AngleAxisd(flexion, Vector3d::UnitY()).toRotationMatrix();
  const Vector3d hip = m.rest[thigh.proximal];
  const double radius = 0.8 * 0.5 * std::min(thigh.breadth, thigh.depth);
  double gap = -kInfinity;
  for (int i = 0; i <= kCircles; ++i)
    for (int k = 0; k < 2 * kCircles; ++k) {
      const double down = kPi * i / kCircles, around = kPi * k / kCircles;
      const Vector3d d = radius * Vector3d(std::sin(down) * std::cos(around),
                                           std::sin(down) * std::sin(around), std::cos(down));
      gap = std::max(gap, std::min(of_torso->signedDistance(hip + d - restOrigin(m, torso)),
                                   of_thigh->signedDistance(R_PW * d + thigh.p_proximal)));
    }
  return gap;
}

TEST(HumanModel, FlexedHipIsClosedInAnthropometricPreset) {
  constexpr double kClosed = 0.006;  // m
  for (const double height : {1.55, 1.75, 1.95})
    for (const double flexion : {0.0, 45.0, 90.0, 120.0}) {
      EXPECT_LT(gapAtHip(human(height, HumanPreset::kAnthropometric), unit::deg(flexion)), kClosed)
          << height << " " << flexion;
      // The ellipsoid of the thesis's table ends in a point at the hip: TableLeavesGapAtHip.
      if (flexion < 90.0) continue;
      EXPECT_GT(gapAtHip(human(height, HumanPreset::kThesis), unit::deg(flexion)), 0.04) << height;
    }
}

TEST(HumanModel, TableLeavesGapAtHip) {
  // Wherever the hip joint is: lengths of the table let thigh and trunk overlap by 0.009 of the stature, and
  // an ellipsoid of the thigh's length has 0.8 of its girth only 0.05 below its end.
  for (const double height : {1.55, 1.75, 1.95}) {
    const HumanModel m = human(height, HumanPreset::kThesis);
    const HumanPart &torso = m.part(BodyPart::kTorso), &thigh = m.part(BodyPart::kThighLeft);
    const double trunk_end = restOrigin(m, torso).z() - halfExtents(torso.shape).z();
    const double half = halfExtents(thigh.shape).z(), thigh_end = restOrigin(m, thigh).z() + half;
    EXPECT_NEAR(thigh_end - trunk_end, .009 * height, kTable);
    EXPECT_NEAR(half * (1.0 - std::sqrt(1.0 - .8 * .8)), .05 * height, kTable);
    EXPECT_LT(gapAtHip(m, 0.0), 0.025) << height;
    EXPECT_LT(gapAtHip(m, unit::deg(120.0)), 0.076) << height;
  }
}

TEST(HumanModel, LeftAndRightAreMirrorImages) {
  const auto mirror = [](const Vector3d& p) { return Vector3d(p.x(), -p.y(), p.z()); };
  for (const HumanModel& m : variety())
    for (const HumanPart& left : m.parts) {
      if (sideOf(left.part) != 1) continue;
      const HumanPart& right = m.parts[index(left.part) + 1];
      EXPECT_EQ(halfExtents(left.shape), halfExtents(right.shape));
      EXPECT_EQ(left.com, mirror(right.com));
      EXPECT_EQ(left.inertia, right.inertia);
      EXPECT_EQ(m.rest[left.proximal], mirror(m.rest[right.proximal]));
      EXPECT_EQ(m.rest[left.distal], mirror(m.rest[right.distal]));
    }
}

TEST(HumanModel, GrowsWithStatureAndMass) {
  for (const HumanPreset preset : {HumanPreset::kThesis, HumanPreset::kAnthropometric})
    for (double h = 0.6; h < 2.5; h += 0.1) {
      const HumanModel small = human(h - 0.1, preset), large = human(h, preset);
      EXPECT_GT(large.mass, small.mass);
      for (std::size_t i = 0; i < kBodyPartCount; ++i) {
        EXPECT_GT(large.parts[i].length, small.parts[i].length);
        EXPECT_GT(large.parts[i].contour, small.parts[i].contour);
        EXPECT_GT(large.parts[i].mass, small.parts[i].mass);
      }
    }
  for (double mass = 50.0; mass < 150.0; mass += 10.0) {
    const HumanModel lean = human(1.75, HumanPreset::kAnthropometric, mass);
    const HumanModel heavy = human(1.75, HumanPreset::kAnthropometric, mass + 10.0);
    for (std::size_t i = 0; i < kBodyPartCount; ++i)
      EXPECT_GE(heavy.parts[i].contour, lean.parts[i].contour) << partName(lean.parts[i].part);
    EXPECT_GT(heavy.part(BodyPart::kTorso).depth, lean.part(BodyPart::kTorso).depth);
  }
}

TEST(HumanModel, SmallWomanAndLargeManMatchPercentiles) {
  // ANSUR II, 5th percentile woman and 95th percentile man, mm.
  struct Row {
    BodyPart part;
    double woman, man;
  };
  const Row girths[] = {{BodyPart::kHead, 532, 601},        {BodyPart::kBicepsLeft, 259, 418},
                        {BodyPart::kForearmLeft, 235, 348}, {BodyPart::kHandLeft, 173, 230},
                        {BodyPart::kThighLeft, 527, 723},   {BodyPart::kCalfLeft, 328, 443}};
  const Row lengths[] = {{BodyPart::kBicepsLeft, 283, 365},
                         {BodyPart::kForearmLeft, 218, 295},
                         {BodyPart::kHandLeft, 165, 210},
                         {BodyPart::kFootLeft, 226, 293}};
  const HumanModel woman = human(1.525, HumanPreset::kAnthropometric, 51.3, Sex::kFemale);
  const HumanModel man = human(1.870, HumanPreset::kAnthropometric, 110.7, Sex::kMale);
  for (const Row& row : girths) {
    EXPECT_NEAR(woman.part(row.part).contour, unit::mm(row.woman), kPercentile * unit::mm(row.woman))
        << partName(row.part);
    EXPECT_NEAR(man.part(row.part).contour, unit::mm(row.man), kPercentile * unit::mm(row.man))
        << partName(row.part);
  }
  for (const Row& row : lengths) {
    EXPECT_NEAR(woman.part(row.part).length, unit::mm(row.woman), kPercentile * unit::mm(row.woman))
        << partName(row.part);
    EXPECT_NEAR(man.part(row.part).length, unit::mm(row.man), kPercentile * unit::mm(row.man))
        << partName(row.part);
  }
  // The torso's cuboid goes round every girth of the trunk.
  for (const HumanModel* m : {&woman, &man}) {
    const BodyMeasures measured = measuresOf(m->height, m->mass, m->options.sex);
    const HumanPart& torso = m->part(BodyPart::kTorso);
    EXPECT_GE(torso.contour, measured.chest_girth);
    EXPECT_GE(torso.contour, measured.waist_girth);
    EXPECT_GE(torso.contour, measured.buttock_girth);
  }
  EXPECT_NEAR(measuresOf(1.525, 51.3, Sex::kFemale).chest_girth, 0.824, kPercentile * 0.824);
  EXPECT_NEAR(measuresOf(1.870, 110.7, Sex::kMale).waist_girth, 1.131, kPercentile * 1.131);
}

TEST(HumanModel, DefaultMassMatchesMeanPersonOfTables) {
  EXPECT_NEAR(human(1.7562, HumanPreset::kAnthropometric, {}, Sex::kMale).mass, 85.5, kTable);
  EXPECT_NEAR(human(1.6285, HumanPreset::kAnthropometric, {}, Sex::kFemale).mass, 67.8, kTable);
  const double men = meanBodyMassIndex(Sex::kMale), women = meanBodyMassIndex(Sex::kFemale);
  EXPECT_NEAR(meanBodyMassIndex({}), 0.5 * (men + women), kRounding);
  // The lines of girth in body mass index pass through the mean girths.
  EXPECT_NEAR(measuresOf(1.0, men, Sex::kMale).chest_girth, .603, 1e-3);
  EXPECT_NEAR(measuresOf(1.0, women, Sex::kFemale).thigh_girth, .379, 1e-3);
}

TEST(HumanModel, RejectsOutOfRangeValues) {
  for (const double h : {0.0, -1.0, kNaN, 17.0, 0.4, kInfinity, -kInfinity, 2.5001})
    EXPECT_THROW(human(h), UsageError) << h;
  for (const double m : {0.0, -70.0, kNaN, 9.9, 301.0, kInfinity})
    EXPECT_THROW(human(1.75, HumanPreset::kAnthropometric, m), UsageError) << m;
  EXPECT_THROW(human(0.5, HumanPreset::kAnthropometric, 200.0), UsageError) << "800 kg/m^2";
  EXPECT_THROW(human(2.4, HumanPreset::kThesis, 20.0), UsageError) << "3.5 kg/m^2";
  EXPECT_NO_THROW(human(0.5));
  EXPECT_NO_THROW(human(2.5));
}

}  // namespace human_model_test
}  // namespace abstand::humanmodel
