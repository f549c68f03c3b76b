// Clothing widens parts by no less than its thickness; what a hand holds moves no farther than its bound.
#include "humanmodel/clothing.hpp"

#include <gtest/gtest.h>

#include <random>

#include "core/base/error.hpp"
#include "humanmodel/enclosed_share.hpp"
#include "humanmodel/held_tool.hpp"

namespace abstand::humanmodel {
namespace clothing_test {

constexpr double kRounding = 1e-12;
constexpr int kTries = 20000;

Vector3d direction(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  return Vector3d(normal(random), normal(random), normal(random)).normalized();
}

/// m: support function of an ellipsoid about the origin.
double support(const geometry::Shape& shape, const Vector3d& u) {
  return std::get<geometry::Ellipsoid>(shape).semi_axes.cwiseProduct(u).norm();
}

TEST(Clothing, AnEllipsoidContainsEveryPointWithinTheThickness) {
  std::mt19937_64 random(1);
  for (const Vector3d& axes : {Vector3d(0.095, 0.045, 0.015), Vector3d(0.05, 0.05, 0.2), Vector3d(1, 1, 1)})
    for (const double thickness : {0.001, 0.01, 0.1}) {
      const geometry::Shape bare = geometry::Ellipsoid{axes}, worn = widened(bare, thickness);
      for (int i = 0; i < kTries; ++i) {
        const Vector3d u = direction(random);
        ASSERT_GE(support(worn, u), support(bare, u) + thickness - kRounding) << axes.transpose();
      }
    }
}

TEST(Clothing, NoOtherOfTheFamilyOfEnclosingEllipsoidsHasSmallerAxes) {
  const Vector3d a(0.095, 0.045, 0.015);
  const double d = 0.01;
  const auto sum = [&](double p) { return (1 + 1 / p) * a.squaredNorm() + 3 * (1 + p) * d * d; };
  const double got =
      std::get<geometry::Ellipsoid>(widened(geometry::Ellipsoid{a}, d)).semi_axes.squaredNorm();
  double least = kInfinity;
  for (double p = 0.01; p < 100.0; p *= 1.0005) least = std::min(least, sum(p));
  // p is sampled in steps of 0.05 %; the minimum is flat.
  EXPECT_NEAR(got, least, 1e-7 * least);
}

TEST(Clothing, OfABallAndACuboidIsExact) {
  const auto ball = std::get<geometry::Ellipsoid>(widened(geometry::Ellipsoid{{0.1, 0.1, 0.1}}, 0.02));
  EXPECT_NEAR((ball.semi_axes - Vector3d::Constant(0.12)).norm(), 0.0, kRounding);
  const auto box = std::get<geometry::Cuboid>(widened(geometry::Cuboid{{0.3, 0.4, 0.5}}, 0.02));
  EXPECT_NEAR((box.size - Vector3d(0.34, 0.44, 0.54)).norm(), 0.0, kRounding);
}

TEST(Clothing, ChangesTheShapesAlone) {
  HumanOptions options;
  const HumanModel bare = makeHuman(options);
  addClothingPreset("winter_clothes", options.clothing);
  addClothingPreset("gloves", options.clothing);
  const HumanModel worn = makeHuman(options);
  const auto shares = enclosedShare(bare, {}), worn_shares = enclosedShare(worn, {});
  for (std::size_t i = 0; i < kBodyPartCount; ++i) {
    const HumanPart &a = bare.parts[i], &b = worn.parts[i];
    EXPECT_EQ(geometry::bounds(a.shape).extent(), geometry::bounds(b.bare).extent());
    const bool covered = options.clothing.contains(a.part);
    EXPECT_EQ((geometry::bounds(b.shape).extent() - geometry::bounds(a.shape).extent()).minCoeff() > 0.0,
              covered)
        << partName(a.part);
    EXPECT_EQ(a.mass, b.mass);
    EXPECT_EQ(a.p_distal, b.p_distal);
    EXPECT_EQ(a.contour, b.contour);
    EXPECT_EQ(shares[i].at_stature, worn_shares[i].at_stature) << "clothes enclose nobody";
  }
}

TEST(Clothing, TheThickerOneCounts) {
  Clothing worn{{BodyPart::kHandLeft, 0.02}};
  EXPECT_TRUE(addClothingPreset("gloves", worn));
  EXPECT_EQ(worn.at(BodyPart::kHandLeft), 0.02);
  EXPECT_EQ(worn.at(BodyPart::kHandRight), 0.003);
  EXPECT_FALSE(addClothingPreset("tie", worn));
  for (const std::string_view name : clothingPresets()) EXPECT_TRUE(addClothingPreset(name, worn)) << name;
}

TEST(Clothing, RefusesWhatNobodyWears) {
  HumanOptions options;
  for (const double thickness : {-0.01, 0.3, kNaN}) {
    options.clothing = {{BodyPart::kHead, thickness}};
    EXPECT_THROW(makeHuman(options), UsageError) << thickness;
  }
}

TEST(HeldTool, GoesNoFartherThanTheUncertaintyOfTheHandAllows) {
  const HumanPart hand = makeHuman({}).part(BodyPart::kHandRight);
  const Vector3d half = std::get<geometry::Ellipsoid>(hand.bare).semi_axes;
  const double lever = turnLever(hand);
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  double largest = 0.0;
  for (int i = 0; i < kTries; ++i) {
    const Eigen::AngleAxisd turn(share(random) * kPi, direction(random));
    const Vector3d shift = 0.05 * share(random) * direction(random);
    const double reach = 0.5 * share(random);
    const Vector3d tip = reach * direction(random);
    // How far the hand's points are from where they are shown: those of its surface, of which some suffice to
    // bound the uncertainty from below.
    double uncertainty = shift.norm();
    for (int k = 0; k < 3; ++k)
      for (const double sign : {-1.0, 1.0}) {
        const Vector3d p = sign * half[k] * Vector3d::Unit(k);
        uncertainty = std::max(uncertainty, (turn * p + shift - p).norm());
      }
    const double moved = (turn * tip + shift - tip).norm();
    const double bound = heldUncertainty(uncertainty, reach, lever);
    ASSERT_LE(moved, bound + kRounding);
    largest = std::max(largest, moved / bound);
  }
  EXPECT_GT(largest, 0.9) << "the bound is not much larger than need be";
}

TEST(HeldTool, UncertaintyInClosedForm) {
  EXPECT_EQ(heldUncertainty(0.0, 0.3, 0.04), 0.0);
  EXPECT_NEAR(heldUncertainty(0.01, 0.3, 0.04), 0.01 + 0.3 * 0.25, kRounding);
  EXPECT_NEAR(heldUncertainty(0.5, 0.3, 0.04), 0.5 + 0.6, kRounding) << "turned round";
  EXPECT_EQ(heldUncertainty(kInfinity, 0.3, 0.04), kInfinity);
}

}  // namespace clothing_test
}  // namespace abstand::humanmodel
