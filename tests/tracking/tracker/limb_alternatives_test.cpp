// Places that explain the image as well count for some time, others never.
#include "tracking/tracker/limb_alternatives.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/no_alloc.hpp"
#include "tests/tracking/tracker/upright_person.hpp"

namespace abstand::tracking {
namespace limb_alternatives_test {

using enum humanmodel::Joint;

constexpr double kCost = 2.0 * LimbAlternatives::kDoubtfulCost;  // m^2
constexpr double kFarAway = 2.0 * LimbAlternatives::kFar;
constexpr double kRounding = 1e-12;
constexpr std::size_t kLeftArm = 0, kRightLeg = 3;  // of kLimbs

std::size_t at(humanmodel::Joint joint) { return static_cast<std::size_t>(joint); }

struct Alternatives : ::testing::Test {
  BodyRig rig = makeRig(humanmodel::makeHuman({}));
  RigPlacement X_WS = uprightAt(rig, Vector3d::Zero());
  LimbAlternatives alternatives;

  /// A place whose elbow and wrist are this far from the fitted ones.
  LimbTry placeOf(double cost, double elbow, double wrist, std::size_t limb = kLeftArm) const {
    return {cost, X_WS[index(kLimbs[limb].lower)].translation() + elbow * Vector3d::UnitX(),
            X_WS[index(kLimbs[limb].end)].translation() + wrist * Vector3d::UnitY()};
  }
  void see(double t, const std::vector<LimbTry>& tries, std::size_t limb = kLeftArm) {
    alternatives.begin(t);
    alternatives.add(limb, tries, kCost, X_WS);
  }
  double distance(humanmodel::Joint joint) const { return alternatives.distance()[at(joint)]; }
};

TEST_F(Alternatives, AreTheFarthestPlacesThatCostAboutAsMuch) {
  see(0.0, {placeOf(1.1 * kCost, 0.2, 0.4), placeOf(0.9 * kCost, 0.3, 0.35), placeOf(1.3 * kCost, 0.8, 0.9)});
  EXPECT_NEAR(distance(kElbowLeft), 0.3, kRounding);
  EXPECT_NEAR(distance(kWristLeft), 0.4, kRounding);
  EXPECT_NEAR(distance(kHandLeft), 0.4, kRounding) << "moves with the wrist";
  for (const humanmodel::Joint joint : {kShoulderLeft, kElbowRight, kWristRight, kKneeLeft, kHead})
    EXPECT_EQ(distance(joint), 0.0);
}

TEST_F(Alternatives, OfABodyThatFitsWellCostAsMuchMoreAsOfADoubtfulOne) {
  constexpr double kGood = 0.25 * LimbAlternatives::kDoubtfulCost;
  constexpr double kMore = (LimbAlternatives::kAlike - 1.0) * LimbAlternatives::kDoubtfulCost;
  alternatives.begin(0.0);
  alternatives.add(kLeftArm, std::vector{placeOf(kGood + 0.9 * kMore, 0.2, 0.4)}, kGood, X_WS);
  alternatives.add(kLeftArm, std::vector{placeOf(kGood + 1.1 * kMore, 0.8, 0.9)}, kGood, X_WS);
  EXPECT_NEAR(distance(kElbowLeft), 0.2, kRounding);
  EXPECT_NEAR(distance(kWristLeft), 0.4, kRounding);
}

TEST_F(Alternatives, OfALegMoveKneeAnkleAndToe) {
  see(0.0, {placeOf(kCost, 0.2, 0.4, kRightLeg)}, kRightLeg);
  EXPECT_NEAR(distance(kKneeRight), 0.2, kRounding);
  EXPECT_NEAR(distance(kAnkleRight), 0.4, kRounding);
  EXPECT_NEAR(distance(kToeRight), 0.4, kRounding);
  EXPECT_EQ(distance(kHipRight), 0.0);
  EXPECT_EQ(distance(kAnkleLeft), 0.0);
}

TEST_F(Alternatives, NearTheFittedPlaceDoNotCount) {
  const double near = 0.9 * LimbAlternatives::kFar;
  see(0.0, {placeOf(kCost, near, near)});
  EXPECT_EQ(distance(kElbowLeft), 0.0);
  EXPECT_EQ(distance(kWristLeft), 0.0);
}

TEST_F(Alternatives, DecayUntilTheyAreFoundAgain) {
  see(0.0, {placeOf(kCost, 0.0, kFarAway)});
  see(1.0, {});
  const double left = kFarAway * std::exp(-1.0 / LimbAlternatives::kDecay);
  EXPECT_NEAR(distance(kWristLeft), left, kRounding);
  see(1.0, {placeOf(kCost, 0.0, kFarAway)});
  EXPECT_NEAR(distance(kWristLeft), kFarAway, kRounding)
      << "the same time: another camera, or the image again";
  alternatives.forget();
  EXPECT_EQ(distance(kWristLeft), 0.0);
}

TEST_F(Alternatives, AllocateNothing) {
  const std::vector<LimbTry> tries(100, placeOf(kCost, kFarAway, kFarAway));
  testing::NoAlloc guard;
  alternatives.begin(0.0);
  alternatives.add(kLeftArm, tries, kCost, X_WS);
  EXPECT_EQ(guard.count(), 0);
}

}  // namespace limb_alternatives_test
}  // namespace abstand::tracking
