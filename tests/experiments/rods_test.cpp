// Thesis 5.2: two rods, one turning into the other; direction and sense of forces and torques, third law.
#include <gtest/gtest.h>

#include "core/scene/scene.hpp"
#include "tests/support/structures.hpp"

namespace abstand::testing {
namespace rods_test {

const Vector3d kRod{0.4, 0.04, 0.04};
const Vector3d kWideRod{0.4, 0.04,
                        0.2};  // its sides are far from the turning rod, so depth is that below its face
const Vector3d kFixedCentre{0.15, 0.13, 0.0};
constexpr double kStiffness = 1e6;

/// Rod A turns about z through its centre, counter-clockwise; its end comes up against the lower face of rod
/// B.
struct Rods {
  scene::Scene scene;
  ObjectId a, b;
  explicit Rods(const Vector3d& fixed = kRod) : a(add("turning", kRod)), b(add("fixed", fixed)) {
    scene.addPair(a, b);
    scene.setForceLaw(query::ForceLaw::kVolume, kStiffness);
    scene.setPose(b, fromXyzRpy(kFixedCentre, Vector3d::Zero()), 0.0);
  }
  ObjectId add(const char* name, const Vector3d& size) {
    const auto& shared = structureOf(geometry::Cuboid{size}, structure::FieldKind::kMixed);
    return scene.addObject(
        {name, "objects", std::shared_ptr<const structure::HapticStructure>(&shared, [](auto*) {}), 0.0});
  }
  const query::PairResult& turn(double angle, double t) {
    scene.setPose(a, fromXyzRpy(Vector3d::Zero(), {0, 0, angle}), t);
    scene.step();
    return scene.pairs()[0].result;
  }
};

/// Area of the part of the turning rod's outline above the fixed rod's lower face: the corner is a right
/// triangle.
double overlapArea(double angle) {
  const double top = 0.2 * std::sin(angle) + 0.02 * std::cos(angle);
  const double depth = top - (kFixedCentre.y() - 0.02);
  return depth <= 0 ? 0.0 : depth * depth / (2 * std::sin(angle) * std::cos(angle));
}

TEST(ThesisRods, NoForceWhenApart) {
  Rods rods;
  const query::PairResult& r = rods.turn(0.2, 0.0);
  EXPECT_GT(r.distance, 0.03);
  EXPECT_EQ(r.contacts, 0);
  EXPECT_EQ(r.force_a.norm(), 0.0);
}

TEST(ThesisRods, ForcesPushApartAndTorquesOpposeRotation) {
  Rods rods;
  int touching = 0;
  double t = 0.0;
  for (double angle = 0.40; angle < 0.56; angle += 0.01) {
    SCOPED_TRACE(angle);
    const query::PairResult& r = rods.turn(angle, t += 0.001);
    if (r.contacts == 0) continue;
    ++touching;
    EXPECT_LT(r.force_a.y(), 0.0);                                // the turning rod is pushed back down
    EXPECT_GT(-r.force_a.y(), 5 * std::abs(r.force_a.x()));       // along the fixed rod's normal
    EXPECT_LT(std::abs(r.force_a.z()), 0.02 * r.force_a.norm());  // in the plane
    EXPECT_LT(r.torque_a.z(), 0.0);                               // against the turning
    const scene::Object& a = rods.scene.object(rods.a);
    const scene::Object& b = rods.scene.object(rods.b);
    EXPECT_EQ((a.contact.force + b.contact.force).norm(), 0.0);  // third law
    const Vector3d ab = b.p_WCom() - a.p_WCom();
    // T_A = -T_B - AB x F_B: the thesis's equation 5.2 with the term that it drops.
    const Vector3d expected = -b.contact.torque - ab.cross(b.contact.force);
    EXPECT_LE((a.contact.torque - expected).norm(), 1e-12 * a.contact.torque.norm());
  }
  EXPECT_GE(touching, 5);
}

TEST(ThesisRods, ForceIsStiffnessTimesOverlap) {
  Rods rods(kWideRod);
  for (const double angle : {0.55, 0.58, 0.60}) {
    SCOPED_TRACE(angle);
    const double expected = kStiffness * overlapArea(angle) * 0.04;
    // The corner's area is a few voxels across; five per cent is what 5 mm can promise there.
    EXPECT_NEAR(-rods.turn(angle, angle).force_a.y(), expected, 0.05 * expected);
  }
}

}  // namespace rods_test
}  // namespace abstand::testing
