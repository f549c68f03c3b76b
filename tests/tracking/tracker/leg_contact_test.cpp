// Distances of the axes of two legs, against closed forms and points on both axes.
#include "tracking/tracker/leg_contact.hpp"

#include <gtest/gtest.h>

#include <random>

#include "tests/support/no_alloc.hpp"
#include "tests/tracking/tracker/seated_pose.hpp"
#include "tests/tracking/tracker/upright_person.hpp"

namespace abstand::tracking {
namespace leg_contact_test {

constexpr double kRounding = 1e-12;  // m

/// Joints of both legs (m): hip, knee, ankle.
using Leg = std::array<Vector3d, 3>;
RigPlacement placed(const Leg& left, const Leg& right) {
  using enum RigSegment;
  RigPlacement X_WS;
  X_WS.fill(Transform::Identity());
  const auto put = [&](const Leg& leg, const std::array<RigSegment, 3>& segments) {
    for (std::size_t i = 0; i < leg.size(); ++i) X_WS[index(segments[i])].translation() = leg[i];
  };
  put(left, {kThighLeft, kCalfLeft, kFootLeft});
  put(right, {kThighRight, kCalfRight, kFootRight});
  return X_WS;
}
Leg moved(const Leg& leg, const Vector3d& by) { return {leg[0] + by, leg[1] + by, leg[2] + by}; }
const Leg kStraight{{{0.0, 0.0, 0.9}, {0.0, 0.0, 0.5}, {0.0, 0.0, 0.1}}};

TEST(LegContact, IsNoneBetweenTheLegsOfPeopleWhoStandOrSit) {
  const BodyRig rig = makeRig(humanmodel::makeHuman({}));
  for (const RigPlacement& X_WS : {uprightAt(rig, Vector3d::Zero()), seatedPlacement(rig)})
    for (const LegContact& contact : legContacts(X_WS)) EXPECT_EQ(contact.depth, 0.0);
}

TEST(LegContact, OfParallelLegsIsWhatTheirDistanceLacks) {
  const Vector3d apart(0.03, 0.04, 0.0);  // 0.05 m
  for (const LegContact& contact : legContacts(placed(moved(kStraight, apart), kStraight))) {
    EXPECT_NEAR(contact.depth, kLegsApart - 0.05, kRounding);
    EXPECT_TRUE(contact.n.isApprox(apart / 0.05, 1e-9)) << "from the right one to the left one";
    EXPECT_TRUE((contact.p_left - contact.p_right).isApprox(apart, 1e-9));
  }
  for (const LegContact& contact :
       legContacts(placed(moved(kStraight, 1.01 * kLegsApart * Vector3d::UnitX()), kStraight)))
    EXPECT_EQ(contact.depth, 0.0);
}

TEST(LegContact, OfCrossedThighsIsWhereTheyCross) {
  const Leg left{{{0.0, 0.1, 0.5}, {0.4, -0.1, 0.52}, {0.4, -0.1, 0.1}}};
  const Leg right{{{0.0, -0.1, 0.5}, {0.4, 0.1, 0.48}, {0.4, 0.1, 0.1}}};
  const auto [thighs, calves] = legContacts(placed(left, right));
  EXPECT_NEAR(thighs.depth, kLegsApart - 0.02, 1e-4) << "0.02 m above each other";
  EXPECT_NEAR(thighs.n.z(), 1.0, 1e-2);
  EXPECT_NEAR(thighs.p_left.x(), 0.2, 1e-2);
  EXPECT_EQ(calves.depth, 0.0);
}

TEST(LegContact, IsTheSmallestDistanceOfAnyTwoPoints) {
  constexpr int kSteps = 200;
  constexpr double kStep = 0.4 / kSteps;  // m, at most, between neighbouring points
  std::mt19937_64 random{7};
  std::uniform_real_distribution<double> within(-0.06, 0.06);
  const auto jolted = [&] {
    Leg leg = kStraight;
    for (Vector3d& p : leg)
      for (double& x : p) x += within(random);
    return leg;
  };
  for (int k = 0; k < 50; ++k) {
    const Leg left = jolted(), right = jolted();
    const auto contacts = legContacts(placed(left, right));
    for (std::size_t bone = 0; bone < contacts.size(); ++bone) {
      double smallest = kInfinity;
      for (int i = 0; i <= kSteps; ++i)
        for (int j = 0; j <= kSteps; ++j) {
          const auto on = [&](const Leg& leg, int step) {
            return Vector3d(leg[bone] + static_cast<double>(step) / kSteps * (leg[bone + 1] - leg[bone]));
          };
          smallest = std::min(smallest, (on(left, i) - on(right, j)).norm());
        }
      EXPECT_NEAR(contacts[bone].depth, std::max(0.0, kLegsApart - smallest), kStep) << k;
    }
  }
}

TEST(LegContact, WithoutADirectionIsNone) {
  testing::NoAlloc guard;
  const auto same = legContacts(placed(kStraight, kStraight));
  const auto points = legContacts(placed({}, {}));
  EXPECT_EQ(guard.count(), 0);
  for (const auto& contacts : {same, points})
    for (const LegContact& contact : contacts) EXPECT_EQ(contact.depth, 0.0);
}

}  // namespace leg_contact_test
}  // namespace abstand::tracking
