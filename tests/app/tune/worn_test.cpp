// Clothing and tools in hands against closed forms.
#include <gtest/gtest.h>

#include "app/tune/closest_approach.hpp"
#include "app/tune/plan.hpp"
#include "app/tune/result_file.hpp"
#include "app/tune/worst_phase.hpp"
#include "humanmodel/held_tool.hpp"
#include "tests/app/tune/slide_scene.hpp"

namespace abstand::tune {
namespace worn_test {

// m: the engine's distances are within 0.2 % of the true ones far away.
constexpr double kRelative = 2e-3, kEngine = 3e-4;
constexpr testing::SlideSpeeds kSpeeds{.robot = 0.5, .seconds = 3.0};
constexpr double kBall = 0.05, kStart = -2.4, kHeight = 1.2;  // m, of the slide

std::unique_ptr<session::Session> openWorn(const testing::ScratchFolder& folder, const WornVariant& worn) {
  scene_file::SceneDescription scene = scene_file::loadScene(testing::writeSlide(folder, kSpeeds));
  PlanItem item;
  item.worn = worn;
  item.apply(scene);
  session::SessionOptions options;
  options.threads = 1;
  options.cache = false;
  options.rest = 0.0;
  return depth::openSession(std::move(scene), options);
}

const PartClearance& partOf(const TunedRecording& tuned, const std::string& name) {
  for (const PartClearance& part : tuned.pass.parts)
    if (part.part == name) return part;
  throw std::runtime_error("no part " + name);
}

/// A ball of 40 mm in the right hand, on the way of the robot's ball: 0.6 m before the person's middle.
scene_file::ToolDescription ballTool() {
  scene_file::ToolDescription tool;
  tool.name = "ball";
  tool.shape = geometry::Sphere{0.04};
  const humanmodel::HumanModel model = humanmodel::makeHuman({});
  // In the rest pose the hand's axes are those of the world.
  const humanmodel::HumanPart& hand = model.part(humanmodel::BodyPart::kHandRight);
  const Vector3d centre = model.rest[hand.proximal] - hand.p_proximal;
  tool.X_HT.translation() = Vector3d(-0.6, 0.0, kHeight) - centre;
  return tool;
}

TEST(Worn, AToolIsABodyOfThePersonAndCountsAsTheHand) {
  const testing::ScratchFolder folder;
  const auto session = openWorn(folder, {{}, {ballTool()}});
  ASSERT_TRUE(session->scene().find("person/hand_right/ball"));
  EXPECT_EQ(session->scene().find("person/hand_right/ball")->spec.group, "person");
  const TunedRecording tuned = tuneRecording(*session, {}, {}, "slide");
  EXPECT_EQ(tuned.pass.parts.size(), humanmodel::kBodyPartCount);
  const PartClearance& hand = partOf(tuned, "hand_right");
  for (std::size_t i = 0; i < hand.track.frames(); ++i) {
    const double robot = kStart + kSpeeds.robot * hand.track.t[i];
    const double expected = std::abs(-0.6 - robot) - kBall - 0.04;
    if (expected < 0.02) continue;
    EXPECT_NEAR(hand.distance[i], expected, kRelative * expected + kEngine) << hand.track.t[i];
    EXPECT_LE(hand.track.clearance[i], expected + 1e-9);
  }
}

TEST(Worn, AToolMovesWithItsHandAndIsUncertainWithIt) {
  const testing::ScratchFolder folder;
  scene_file::ToolDescription tool = ballTool();
  const auto session = openWorn(folder, {{}, {tool}});
  scene::Scene& scene = session->scene();
  humanmodel::SkeletonFrame frame = humanmodel::makeHuman({}).rest;
  const double elbow = frame[humanmodel::Joint::kElbowRight].z();
  for (const humanmodel::Joint joint : {humanmodel::Joint::kWristRight, humanmodel::Joint::kHandRight}) {
    // The forearm points forward.
    const Vector3d p = frame[joint];
    frame.set(joint, {elbow - p.z(), p.y(), elbow});
    frame.spread[static_cast<std::size_t>(joint)] = 0.005;
  }
  frame.t = 1.0;
  session->humans().front()->follow(frame, scene);
  const scene::Object &hand = *scene.find("person/hand_right"), &held = *scene.find("person/hand_right/ball");
  EXPECT_NEAR((held.X_WB.translation() - hand.X_WB * tool.X_HT.translation()).norm(), 0.0, 1e-12);
  EXPECT_NEAR((held.X_WB.linear() - hand.X_WB.linear()).norm(), 0.0, 1e-12);
  ASSERT_GT(hand.pose_uncertainty, 0.0);
  const humanmodel::HumanPart& part =
      session->humans().front()->model().part(humanmodel::BodyPart::kHandRight);
  const double reach = tool.X_HT.translation().norm() + 0.04;
  EXPECT_NEAR(held.pose_uncertainty,
              humanmodel::heldUncertainty(hand.pose_uncertainty, reach, humanmodel::turnLever(part)), 1e-3);
  EXPECT_EQ(held.pose_age_uncertainty, 0.0);
  session->humans().front()->markStale(1.5, scene);
  EXPECT_EQ(held.pose_state, scene::PoseState::kStale);
  EXPECT_GT(held.pose_age_uncertainty, hand.pose_age_uncertainty);
}

TEST(Worn, ClothingTakesItsThicknessFromTheDistance) {
  const testing::ScratchFolder folder;
  constexpr double kThick = 0.02;
  const auto bare = openWorn(folder, {});
  const auto worn = openWorn(folder, {{{humanmodel::BodyPart::kTorso, kThick}}, {}});
  const TunedRecording a = tuneRecording(*bare, {}, {}, "slide"), b = tuneRecording(*worn, {}, {}, "slide");
  const PartClearance &before = partOf(a, "torso"), &after = partOf(b, "torso");
  for (std::size_t i = 0; i < before.track.frames(); ++i)
    EXPECT_NEAR(after.distance[i], before.distance[i] - kThick, 2 * kRelative * before.distance[i] + kEngine);
  EXPECT_EQ(partOf(a, "head").distance, partOf(b, "head").distance) << "the head is bare";
}

TEST(Worn, ResultsNameTheToolThatIsNearerThanTheHand) {
  const testing::ScratchFolder folder;
  const auto session = openWorn(folder, {{}, {ballTool()}});
  const TunedRecording tuned = tuneRecording(*session, {}, {}, "slide");
  ASSERT_EQ(tuned.pass.tools, std::vector<std::string>{"person/hand_right/ball"});
  // The ball is 0.6 m before the hand, on the robot's way.
  for (const std::uint16_t tool : partOf(tuned, "hand_right").tool)
    EXPECT_EQ(tuned.pass.toolName(tool), "person/hand_right/ball");
  for (const std::uint16_t tool : partOf(tuned, "hand_left").tool) EXPECT_EQ(tool, kNoTool);
  for (const ClosestApproach& closest : closestApproaches({tuned}, 0.0))
    EXPECT_EQ(closest.tool, closest.part == "hand_right" ? "person/hand_right/ball" : "") << closest.part;
  // Through a file as well.
  const std::filesystem::path file = folder.path() / "result.h5";
  ResultWriter writer(file, {}, hdf5::Compression::kDeflate);
  writer.commit(tuned, {});
  const StoredResult stored = readResult(file);
  EXPECT_EQ(stored.tuned.pass.tools, tuned.pass.tools);
  EXPECT_EQ(partOf(stored.tuned, "hand_right").tool, partOf(tuned, "hand_right").tool);
  EXPECT_EQ(partOf(stored.tuned, "hand_left").tool, partOf(tuned, "hand_left").tool);
  for (std::size_t p = 0; p < tuned.pass.pairs.size(); ++p)
    EXPECT_EQ(stored.tuned.pass.pairs[p].tool, tuned.pass.pairs[p].tool);
}

TEST(Worn, TheWorstPhaseKnowsTheTool) {
  const testing::ScratchFolder folder;
  const auto session = openWorn(folder, {{}, {ballTool()}});
  for (const WorstPhase& worst : worstPhases(*session, {}))
    if (worst.part == "person/hand_right/ball") {
      // At the end of the program.
      const double nearest = -0.6 - (kStart + kSpeeds.robot * kSpeeds.seconds) - kBall - 0.04;
      EXPECT_NEAR(worst.lower, nearest, 1e-3 + kRelative * nearest);
      return;
    }
  FAIL() << "no phase of the tool";
}

}  // namespace worn_test
}  // namespace abstand::tune
