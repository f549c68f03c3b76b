// Choice among poses that explain the same room.
#include "tracking/depth/calibration/room_choice.hpp"

#include <gtest/gtest.h>

namespace abstand::testing {
namespace room_choice_test {

const Vector3d kMiddle(0.0, 0.0, 2.0);

/// An acceptable pose at x (m).
tracking::RoomCandidate poseAt(double x, double seen_through, double cost = 0.004) {
  tracking::RoomCandidate c;
  c.X_WC.translation().x() = x;
  c.cost = cost;
  c.rms = 0.001;
  c.points = 50000;
  c.agreement = {.shared = 0.6, .agreeing = 0.96, .seen_through = seen_through, .weakest = 0.03};
  c.spread = 0.001;
  return c;
}

Transform startAt(double x) { return Transform(Eigen::Translation3d(x, 0.0, 0.0)); }

TEST(RoomChoice, PrefersWhatIsNotSeenThroughToLowCost) {
  const std::vector<tracking::RoomCandidate> poses{poseAt(0.8, 0.02, 0.001), poseAt(0.0, 0.001, 0.005)};
  const tracking::RoomChoice choice = tracking::chooseRoomPose(poses, startAt(0.8), kMiddle);
  EXPECT_EQ(choice.best, 1u);
  EXPECT_FALSE(choice.rival);
  EXPECT_TRUE(choice.decided);
  // Equally seen through: the lower cost.
  const std::vector<tracking::RoomCandidate> equal{poseAt(0.0, 0.0001, 0.005), poseAt(0.01, 0.0, 0.006)};
  EXPECT_EQ(tracking::chooseRoomPose(equal, startAt(0.0), kMiddle).best, 0u);
}

TEST(RoomChoice, StartDecidesIfOnePoseIsNearAndNoOtherIsBetter) {
  const std::vector<tracking::RoomCandidate> poses{poseAt(0.4, 0.002), poseAt(0.0, 0.0), poseAt(1.2, 0.005)};
  const tracking::RoomChoice near = tracking::chooseRoomPose(poses, startAt(0.1), kMiddle);
  EXPECT_TRUE(near.decided);
  EXPECT_EQ(near.best, 1u);
  EXPECT_EQ(near.rival, 0u) << "the nearest one";
  // Near a pose that explains the room as well.
  EXPECT_EQ(tracking::chooseRoomPose(poses, startAt(0.5), kMiddle).best, 0u);
  // Between two, near none, and near one that explains the room worse.
  for (const double x : {0.2, 0.17, 0.8, 1.2}) {
    const tracking::RoomChoice choice = tracking::chooseRoomPose(poses, startAt(x), kMiddle);
    EXPECT_FALSE(choice.decided) << x;
    EXPECT_TRUE(choice.rival) << x;
  }
  // A start that is turned too far is not near.
  const Transform turned = startAt(0.0) * Eigen::AngleAxisd(unit::deg(23.0), Vector3d::UnitY());
  EXPECT_FALSE(tracking::chooseRoomPose(poses, turned, kMiddle).decided);
}

TEST(RoomChoice, CountsDisagreementAndWhatIsSeenPast) {
  EXPECT_NEAR(tracking::unexplained({.agreeing = 0.96, .seen_through = 0.01}), 0.06, 1e-12);
  // Furniture that was moved fits to itself: less is seen past, but less agrees, or a wall is left out.
  std::vector<tracking::RoomCandidate> poses{poseAt(0.0, 0.0095), poseAt(-0.15, 0.0056)};
  poses[0].agreement.agreeing = 0.988;
  poses[1].agreement.agreeing = 0.942;
  for (const double agreeing : {0.942, 0.975}) {
    poses[1].agreement.agreeing = agreeing;
    poses[1].agreement.weakest = agreeing > 0.95 ? 0.002 : 0.03;
    const tracking::RoomChoice choice = tracking::chooseRoomPose(poses, startAt(0.0), kMiddle);
    EXPECT_EQ(choice.best, 0u) << agreeing;
    EXPECT_FALSE(choice.rival) << agreeing;
  }
}

TEST(RoomChoice, PosesWithinSpreadAndUnacceptableOnesAreNoRivals) {
  std::vector<tracking::RoomCandidate> poses{poseAt(0.0, 0.0), poseAt(0.02, 0.0), poseAt(0.1, 0.0)};
  poses[2].spread = 0.04;
  poses.push_back(poseAt(0.4, 0.0));
  poses[3].agreement.agreeing = 0.84;
  poses.push_back(poseAt(0.5, 0.0));
  poses[4].agreement.weakest = 0.0005;
  poses.push_back(poseAt(0.6, 0.0));
  poses[5].points = 900;
  poses.push_back(poseAt(0.7, 0.0));
  poses[6].rms = 0.021;
  const tracking::RoomChoice choice = tracking::chooseRoomPose(poses, startAt(0.9), kMiddle);
  EXPECT_FALSE(choice.rival);
  EXPECT_TRUE(choice.decided);
  // Without an acceptable pose the one with the lowest cost, for the message.
  poses.erase(poses.begin(), poses.begin() + 3);
  poses[2].cost = 0.001;
  EXPECT_EQ(tracking::chooseRoomPose(poses, startAt(0.0), kMiddle).best, 2u);
}

TEST(RoomChoice, ApartIncludesRotation) {
  const Transform turned = startAt(0.0) * Eigen::AngleAxisd(0.05, Vector3d::UnitY());
  EXPECT_NEAR(tracking::apart(startAt(0.0), turned, kMiddle), 2.0 * 2.0 * std::sin(0.025), 1e-12);
  EXPECT_NEAR(tracking::apart(startAt(0.0), startAt(0.3), kMiddle), 0.3, 1e-12);
}

}  // namespace room_choice_test
}  // namespace abstand::testing
