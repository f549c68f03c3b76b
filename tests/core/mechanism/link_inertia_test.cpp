// Mass of links.
#include "core/mechanism/link_inertia.hpp"

#include <gtest/gtest.h>

#include "core/geometry/shape.hpp"
#include "tests/support/random_pose.hpp"
#include "tests/support/robots.hpp"

namespace abstand::mechanism {
namespace link_inertia_test {

using namespace testing;

// Rounding of a few products near 1.
constexpr double kExact = 1e-12;

double difference(const LinkInertia& a, const LinkInertia& b) {
  return std::max({std::abs(a.mass - b.mass), (a.com_F - b.com_F).cwiseAbs().maxCoeff(),
                   (a.inertia_F - b.inertia_F).cwiseAbs().maxCoeff()});
}

TEST(LinkInertia, HalvesSumToWhole) {
  const LinkInertia left = boxMass(2.0, {0.5, 0.2, 0.3}, {-0.25, 0.1, 0.0}),
                    right = boxMass(2.0, {0.5, 0.2, 0.3}, {0.25, 0.1, 0.0});
  EXPECT_LT(difference(together(left, right), boxMass(4.0, {1.0, 0.2, 0.3}, {0.0, 0.1, 0.0})), kExact);
  EXPECT_EQ(difference(together(left, {}), left), 0.0);
  EXPECT_EQ(difference(together({}, left), left), 0.0);
}

TEST(LinkInertia, TransformRoundTrips) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const Transform X = randomPose(seed);
    const LinkInertia body = boxMass(3.0, {0.5, 0.2, 0.3}, {-0.2, 0.1, 0.4});
    EXPECT_LT(difference(seenFrom(X.inverse(), seenFrom(X, body)), body), kExact);
  }
}

TEST(LinkInertia, SolidHasDensityTimesVolume) {
  const geometry::MassProperties solid =
      geometry::massProperties(geometry::tessellate(geometry::Cuboid{{0.5, 0.2, 0.3}}, 0.01));
  Transform X_FS = Transform::Identity();
  X_FS.translation() = Vector3d(0.1, 0.2, 0.3);
  EXPECT_LT(difference(inertiaOfSolid(solid, 2700.0, X_FS),
                       boxMass(2700.0 * 0.03, {0.5, 0.2, 0.3}, {0.1, 0.2, 0.3})),
            1e-9);  // a mass of 81 kg
}

TEST(LinkInertia, FaultsAreReported) {
  LinkInertia body = boxMass(1.0, {0.1, 0.2, 0.3}, {0, 0, 0});
  EXPECT_EQ(inertiaFault(body), "");
  EXPECT_EQ(inertiaFault({}), "");
  EXPECT_EQ(inertiaFault(pointMass(1.0, {1, 2, 3})), "");
  const auto says = [](const LinkInertia& b) { return inertiaFault(b); };
  LinkInertia bad = body;
  bad.mass = -1.0;
  EXPECT_EQ(says(bad), "found mass -1, expected a number of kg, 0 or more");
  bad.mass = kNaN;
  EXPECT_NE(says(bad).find("found mass nan"), std::string::npos);
  bad = body;
  bad.com_F.x() = kInfinity;
  EXPECT_NE(says(bad).find("centre of mass"), std::string::npos);
  bad = body;
  bad.inertia_F(0, 1) = 0.1;
  EXPECT_NE(says(bad).find("not symmetric"), std::string::npos);
  bad = body;
  bad.inertia_F(0, 0) = -0.1;
  EXPECT_NE(says(bad).find("principal moment"), std::string::npos);
  bad = body;
  bad.inertia_F(0, 0) = kNaN;
  EXPECT_NE(says(bad).find("not finite"), std::string::npos);
  bad = body;
  bad.mass = 0.0;
  EXPECT_NE(says(bad).find("without a mass"), std::string::npos);
}

}  // namespace link_inertia_test
}  // namespace abstand::mechanism
