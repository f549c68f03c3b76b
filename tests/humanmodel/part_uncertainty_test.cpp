// What is not known of a part's place widens its margin, by closed forms.
#include "humanmodel/part_uncertainty.hpp"

#include <gtest/gtest.h>

#include "humanmodel/poser.hpp"
#include "tests/humanmodel/skeletons.hpp"

namespace abstand::humanmodel {
namespace part_uncertainty_test {

TEST(PartUncertainty, QuantileCovers99Percent) {
  // The chi distribution with three degrees of freedom: erf(q / sqrt 2) - sqrt(2 / pi) q exp(-q^2 / 2).
  const double q = kSpreadQuantile;
  const double share = std::erf(q / std::sqrt(2.0)) - std::sqrt(2.0 / kPi) * q * std::exp(-0.5 * q * q);
  EXPECT_NEAR(share, 0.99, 1e-6);  // four decimals of q
}

TEST(PartUncertainty, AgeAndSpreadAdd) {
  EXPECT_EQ(partUncertainty(0.0, 0.0), 0.0);
  EXPECT_DOUBLE_EQ(partUncertainty(0.1, 0.0), 0.1 * 2.0);
  EXPECT_DOUBLE_EQ(partUncertainty(0.1, 0.0, 1.6), 0.16);
  EXPECT_DOUBLE_EQ(partUncertainty(0.0, 0.01), 0.033682);
  EXPECT_DOUBLE_EQ(partUncertainty(0.5, 0.01, 1.6), 0.5 * 1.6 + 0.033682);
}

TEST(PartUncertainty, UnknownIsInfinite) {
  EXPECT_EQ(partUncertainty(kInfinity, 0.0), kInfinity);
  EXPECT_EQ(partUncertainty(0.0, kInfinity), kInfinity);
  EXPECT_EQ(partUncertainty(kNaN, 0.0), kInfinity);
  EXPECT_EQ(partUncertainty(0.0, kNaN), kInfinity);
  EXPECT_EQ(partUncertainty(kInfinity, 0.0, 0.0), kInfinity);
  EXPECT_EQ(partUncertainty(-1.0, -1.0), 0.0);
}

TEST(PartSpread, PropagatesAlongPartsAndStaysWhileHeld) {
  const HumanModel model = makeHuman({});
  Poser poser(model);
  SkeletonFrame frame = model.rest;
  frame.spread[static_cast<std::size_t>(Joint::kElbowLeft)] = 0.02;
  HumanPose pose;
  poser.pose(frame, pose);
  for (const BodyPart p : {BodyPart::kBicepsLeft, BodyPart::kForearmLeft, BodyPart::kHandLeft})
    EXPECT_EQ(pose.spread[index(p)], 0.02) << partName(p);
  for (const BodyPart p : {BodyPart::kTorso, BodyPart::kBicepsRight, BodyPart::kThighLeft})
    EXPECT_EQ(pose.spread[index(p)], 0.0) << partName(p);
  // The neck is known badly: arms and head hang there, legs do not.
  SkeletonFrame bowed = model.rest;
  bowed.spread[static_cast<std::size_t>(Joint::kNeck)] = 0.03;
  HumanPose other;
  Poser(model).pose(bowed, other);
  for (const BodyPart p : {BodyPart::kTorso, BodyPart::kHead, BodyPart::kForearmLeft, BodyPart::kHandRight})
    EXPECT_EQ(other.spread[index(p)], 0.03) << partName(p);
  for (const BodyPart p : {BodyPart::kThighLeft, BodyPart::kFootRight})
    EXPECT_EQ(other.spread[index(p)], 0.0) << partName(p);
  // The forearm is lost: its spread stays and its age grows.
  frame.t = 0.25;
  for (const Joint j : {Joint::kElbowLeft, Joint::kWristLeft, Joint::kHandLeft})
    frame.set(j, Vector3d::Constant(kNaN), JointState::kMissing);
  poser.pose(frame, pose);
  EXPECT_EQ(pose.state[index(BodyPart::kForearmLeft)], PartState::kHeld);
  EXPECT_EQ(pose.spread[index(BodyPart::kForearmLeft)], 0.02);
  EXPECT_DOUBLE_EQ(pose.age[index(BodyPart::kForearmLeft)], 0.25);
}

}  // namespace part_uncertainty_test
}  // namespace abstand::humanmodel
