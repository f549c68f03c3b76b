// What a user overrides is what the part gets.
#include <gtest/gtest.h>

#include "core/base/error.hpp"
#include "humanmodel/cross_section.hpp"
#include "humanmodel/human_model.hpp"

namespace abstand::humanmodel {
namespace overrides_test {

constexpr double kRounding = 1e-12;
constexpr BodyPart kHand = BodyPart::kHandLeft;

HumanModel with(BodyPart part, const PartOverride& wish, HumanPreset preset = HumanPreset::kAnthropometric) {
  HumanOptions options;
  options.height = 1.8;
  options.preset = preset;
  options.overrides[part] = wish;
  return makeHuman(options);
}

PartOverride wish(std::optional<double> length, std::optional<double> contour,
                  std::optional<double> breadth = {}, std::optional<double> depth = {},
                  std::optional<std::string> shape = {}) {
  return {length, contour, breadth, depth, shape};
}

TEST(CrossSection, GirthMatchesClosedForms) {
  EXPECT_NEAR(contourOf(PartShape::kEllipsoid, 2.0, 2.0), 2.0 * kPi, kRounding);
  EXPECT_NEAR(contourOf(PartShape::kCuboid, 2.0, 1.0), 6.0, kRounding);
  // Ellipse with semi-axes 2 and 1: 9.68844822054767619...
  EXPECT_NEAR(contourOf(PartShape::kEllipsoid, 4.0, 2.0), 9.688448220547676, 1e-11);
  EXPECT_NEAR(contourOf(PartShape::kEllipsoid, 2.0, 4.0), 9.688448220547676, 1e-11);
  for (const PartShape shape : {PartShape::kEllipsoid, PartShape::kCuboid})
    for (const double ratio : {0.05, 0.3, 0.8, 1.0, 1.7, 12.0})
      EXPECT_NEAR(extentFor(shape, contourOf(shape, 0.1, 0.1 * ratio), 0.1), 0.1 * ratio, 1e-9) << ratio;
}

TEST(HumanOverrides, GirthScalesBreadthAndDepthTogether) {
  for (const HumanPreset preset : {HumanPreset::kThesis, HumanPreset::kAnthropometric}) {
    const HumanModel usual = with(kHand, {}, preset), changed = with(kHand, wish({}, 0.3), preset);
    const HumanPart &a = usual.part(kHand), &b = changed.part(kHand);
    EXPECT_NEAR(b.contour, 0.3, kRounding);
    EXPECT_NEAR(b.breadth / b.depth, a.breadth / a.depth, kRounding);
    EXPECT_EQ(b.length, a.length);
    EXPECT_EQ(changed.part(BodyPart::kHandRight).contour, usual.part(BodyPart::kHandRight).contour);
  }
}

TEST(HumanOverrides, EachMeasureActsAlone) {
  const HumanPart usual = with(kHand, {}).part(kHand);
  const HumanPart longer = with(kHand, wish(0.25, {})).part(kHand);
  EXPECT_EQ(longer.length, 0.25);
  EXPECT_EQ(longer.contour, usual.contour);
  const HumanPart broad = with(kHand, wish({}, {}, 0.06)).part(kHand);
  EXPECT_EQ(broad.breadth, 0.06);
  EXPECT_EQ(broad.depth, usual.depth);
  EXPECT_NEAR(broad.contour, contourOf(PartShape::kEllipsoid, 0.06, usual.depth), kRounding);
  const HumanPart both = with(kHand, wish({}, 0.3, 0.06)).part(kHand);
  EXPECT_EQ(both.breadth, 0.06);
  EXPECT_NEAR(both.contour, 0.3, 1e-9);
  EXPECT_NEAR(std::get<geometry::Ellipsoid>(both.shape).semi_axes.y(), 0.03, kRounding);
}

TEST(HumanOverrides, ShapeKeepsLengthAndGirth) {
  const HumanPart usual = with(BodyPart::kTorso, {}, HumanPreset::kThesis).part(BodyPart::kTorso);
  const HumanPart round =
      with(BodyPart::kTorso, wish({}, {}, {}, {}, "ellipsoid"), HumanPreset::kThesis).part(BodyPart::kTorso);
  ASSERT_TRUE(std::holds_alternative<geometry::Ellipsoid>(round.shape));
  EXPECT_NEAR(round.contour, usual.contour, kRounding);
  EXPECT_NEAR(2.0 * std::get<geometry::Ellipsoid>(round.shape).semi_axes.z(), usual.length, kRounding);
  const HumanPart box = with(BodyPart::kHead, wish({}, {}, {}, {}, "cuboid")).part(BodyPart::kHead);
  ASSERT_TRUE(std::holds_alternative<geometry::Cuboid>(box.shape));
  EXPECT_NEAR(std::get<geometry::Cuboid>(box.shape).size.z(), box.length, kRounding);
}

TEST(HumanOverrides, LengthMovesJoints) {
  const HumanModel usual = with(BodyPart::kThighLeft, {});
  HumanOptions options = usual.options;
  for (const BodyPart part : {BodyPart::kThighLeft, BodyPart::kThighRight})
    options.overrides[part].length = usual.part(part).length + 0.1;
  const HumanModel tall = makeHuman(options);
  EXPECT_NEAR((tall.rest[Joint::kHipLeft] - tall.rest[Joint::kKneeLeft]).norm(),
              (usual.rest[Joint::kHipLeft] - usual.rest[Joint::kKneeLeft]).norm() + 0.1, kRounding);
  EXPECT_NEAR(tall.rest[Joint::kHeadTop].z(), usual.rest[Joint::kHeadTop].z() + 0.1, kRounding);
  EXPECT_NEAR(tall.rest[Joint::kAnkleLeft].z(), usual.rest[Joint::kAnkleLeft].z(), kRounding);
}

TEST(HumanOverrides, RejectsOutOfRangeValues) {
  const PartOverride bad[] = {wish(0.0, {}),
                              wish(-1.0, {}),
                              wish(kNaN, {}),
                              wish(17.0, {}),
                              wish({}, kInfinity),
                              wish({}, 0.001),
                              wish({}, {}, 100.0),
                              wish({}, {}, {}, -0.1),
                              wish({}, {}, {}, {}, "sphere"),
                              wish({}, 0.3, 0.05, 0.05),
                              wish({}, 0.3, 0.15),
                              wish({}, 0.3, {}, 0.4)};
  for (const PartOverride& o : bad) EXPECT_THROW(with(kHand, o), UsageError);
  try {
    with(kHand, wish(17.0, {}));
    FAIL();
  } catch (const UsageError& e) {
    EXPECT_STREQ(e.what(), "hand_left.length is 17 m, expected 0.005 to 3");
  }
}

}  // namespace overrides_test
}  // namespace abstand::humanmodel
