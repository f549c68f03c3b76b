// Units from the bones that are there, if the stature is not.
#include "tracking/recording/body_size.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "humanmodel/human_model.hpp"

namespace abstand::tracking {
namespace body_size_test {

using humanmodel::Joint;
using humanmodel::SkeletonFrame;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// The standing model in units of the file, with only some joints.
std::vector<SkeletonFrame> part(double height, double units_per_metre, std::initializer_list<Joint> joints) {
  humanmodel::HumanOptions options;
  options.height = height;
  const SkeletonFrame rest = humanmodel::makeHuman(options).rest;
  SkeletonFrame f;
  for (const Joint j : joints) f.set(j, units_per_metre * rest[j]);
  return {f};
}

TEST(BodySize, AnyKnownBoneDeterminesUnit) {
  struct Unit {
    const char* name;
    double per_metre;
  };
  for (const Unit& unit : {Unit{"m", 1.0}, Unit{"cm", 100.0}, Unit{"mm", 1000.0},
                           Unit{"inches", 1.0 / 0.0254}, Unit{"cmu", 0.45 / 0.0254}})
    for (const double height : {1.5, 1.75, 2.0})
      for (const auto& joints : {std::initializer_list<Joint>{Joint::kHipLeft, Joint::kKneeLeft},
                                 {Joint::kKneeRight, Joint::kAnkleRight},
                                 {Joint::kShoulderLeft, Joint::kElbowLeft, Joint::kWristLeft},
                                 {Joint::kHipLeft, Joint::kShoulderLeft, Joint::kKneeLeft}}) {
        const auto frames = part(height, unit.per_metre, joints);
        const auto bones = statureByBones(frames);
        ASSERT_TRUE(bones);
        const UnitChoice choice = chooseUnit("auto", std::nullopt, bones);
        EXPECT_EQ(choice.name, unit.name) << height << " " << humanmodel::jointName(*joints.begin());
        EXPECT_THAT(choice.reason, HasSubstr("of the usual bones the person is about"));
        EXPECT_THAT(choice.warning, IsEmpty());
      }
}

TEST(BodySize, UnknownBonesDetermineNoUnit) {
  EXPECT_FALSE(statureByBones(part(1.75, 1.0, {Joint::kHead, Joint::kNeck, Joint::kWristLeft})));
  EXPECT_FALSE(statureByBones({}));
  EXPECT_THAT(chooseUnit("auto", std::nullopt).warning, HasSubstr("units are unknown"));
  const UnitChoice odd = chooseUnit("auto", std::nullopt, BoneStature{7.0, 2});
  EXPECT_EQ(odd.name, "free");
  EXPECT_DOUBLE_EQ(odd.scale, 0.25);
  EXPECT_THAT(odd.warning, HasSubstr("scaled to about 1.75 m"));
  EXPECT_EQ(chooseUnit("mm", std::nullopt, BoneStature{7.0, 2}).name, "mm");
  EXPECT_EQ(chooseUnit("auto", 175.0, BoneStature{7.0, 2}).name, "cm") << "a stature is better";
}

}  // namespace body_size_test
}  // namespace abstand::tracking
