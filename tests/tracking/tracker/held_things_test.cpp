// Surfaces beside a hand: noticed, forgotten, standing on the floor, too small.
#include "tracking/tracker/held_things.hpp"

#include <gtest/gtest.h>

#include "tests/support/no_alloc.hpp"
#include "tests/tracking/tracker/small_camera.hpp"
#include "tests/tracking/tracker/upright_person.hpp"

namespace abstand::tracking {
namespace held_things_test {

constexpr float kWall = 4.0f;      // m
constexpr double kSampled = 0.06;  // m, cells of 1.7 cm, and what is added for the outline
constexpr double kAllSeen = 1.0, kUnseen = 0.0;

/// A person who stands 2.5 m ahead of the camera with hanging arms. The pixels assigned to the person show a
/// square that faces the camera, beside the left hand.
struct SquareAtHand {
  BodyRig rig = makeRig(humanmodel::makeHuman({}));
  DepthFit fit{rig};
  DepthCamera camera = smallCamera();
  DepthImage image;
  std::vector<std::uint8_t> is_person;
  std::array<double, kRigSegments> visible{};
  BodyObservation seen;
  HeldThings held;

  explicit SquareAtHand(const HeldThings::Extents& at_start = {}) : held{at_start} {
    image = DepthImage(camera.width, camera.height);
    is_person.assign(image.z.size(), 0);
    visible.fill(kAllSeen);
  }
  RigPlacement placed(const Vector3d& moved) const { return uprightAt(rig, moved); }
  Vector3d hand(const Vector3d& moved) const {
    const std::size_t s = index(RigSegment::kHandLeft);
    return placed(moved)[s] * fit.surfaces()[s].centre.cast<double>();
  }
  /// A rectangle (m, to the left of the hand and upwards from it) at the depth of the hand; none if it is
  /// empty. The person has moved by `moved`, the rectangle by `thing_moved`.
  void show(const Eigen::AlignedBox2d& area, const Vector3d& moved, const Vector3d& thing_moved) {
    const Vector3d from = camera.X_WC.inverse() * (hand(Vector3d::Zero()) + thing_moved);
    for (std::size_t i = 0; i < image.z.size(); ++i) {
      const auto u = static_cast<double>(i % static_cast<std::size_t>(image.width)),
                 v = static_cast<double>(i / static_cast<std::size_t>(image.width));
      // The camera's x points to the left of a person who faces it.
      const Vector3d p = camera.at(u, v, from.z());
      is_person[i] = area.contains(Eigen::Vector2d(p.x() - from.x(), from.y() - p.y()));
      image.z[i] = is_person[i] ? static_cast<float>(from.z()) : kWall;
    }
    const PersonImage person{&image, &camera, is_person};
    seen.update({&person, 1});
    held.see(seen, fit, placed(moved), visible);
  }
  void showFor(int images, const Eigen::AlignedBox2d& area, const Vector3d& moved = Vector3d::Zero()) {
    for (int k = 0; k < images; ++k) show(area, moved, moved);
  }
};

Eigen::AlignedBox2d area(double left, double bottom, double right, double top) {
  return {Eigen::Vector2d(left, bottom), Eigen::Vector2d(right, top)};
}
const Eigen::AlignedBox2d kNothing;
// Beside the hand.
const Eigen::AlignedBox2d kBox = area(0.10, -0.10, 0.50, 0.20);

TEST(HeldThings, AreNoticedAfterSomeImages) {
  SquareAtHand scene;
  scene.showFor(HeldThings::kNoticed - 1, kBox);
  EXPECT_EQ(scene.held.extent()[0], 0.0);
  scene.showFor(1, kBox);
  // The farthest point is the rear of the upper left corner; the square is as deep as it is high.
  const Vector3d hand = scene.hand(Vector3d::Zero()), corner = hand + Vector3d(0.0, 0.50, 0.20);
  const Vector3d ray = (corner - scene.camera.X_WC.translation()).normalized();
  const double farthest = (corner + 0.30 * ray - hand).norm();
  const double thickness =
      static_cast<double>(scene.fit.surfaces()[index(RigSegment::kHandLeft)].semi.minCoeff());
  EXPECT_NEAR(scene.held.extent()[0], farthest - thickness, kSampled);
  EXPECT_EQ(scene.held.extent()[1], 0.0) << "the other hand";
  EXPECT_EQ(scene.held.atStart()[0], scene.held.extent()[0]);
}

TEST(HeldThings, AreNoticedSoonerInTheSecondHand) {
  SquareAtHand scene;
  const double apart = 2.0 * scene.hand(Vector3d::Zero()).y();  // m, of the hands
  const Eigen::AlignedBox2d tray = area(-apart - 0.30, -0.10, 0.50, 0.20);
  scene.showFor(HeldThings::kNoticed, kBox);
  ASSERT_GT(scene.held.extent()[0], 0.0);
  scene.showFor(HeldThings::kKept - 1, tray);
  EXPECT_EQ(scene.held.extent()[1], 0.0);
  scene.showFor(1, tray);
  EXPECT_GT(scene.held.extent()[1], 0.0);
}

TEST(HeldThings, AreForgottenWhenTheHandIsEmpty) {
  SquareAtHand scene;
  scene.showFor(HeldThings::kWindow, kBox);
  scene.showFor(HeldThings::kMemory - 1, kNothing);
  EXPECT_GT(scene.held.extent()[0], 0.0);
  scene.showFor(1, kNothing);
  EXPECT_EQ(scene.held.extent()[0], 0.0);
}

TEST(HeldThings, AreRememberedWhileTheHandIsHidden) {
  SquareAtHand scene;
  scene.showFor(HeldThings::kWindow, kBox);
  scene.visible.fill(kUnseen);
  scene.showFor(10 * HeldThings::kWindow, kNothing);
  EXPECT_GT(scene.held.extent()[0], 0.0);
}

TEST(HeldThings, AreNotSmallerThanAFist) {
  SquareAtHand scene;
  scene.showFor(HeldThings::kWindow, area(-0.04, -0.04, 0.04, 0.04));
  EXPECT_EQ(scene.held.extent()[0], 0.0);
}

TEST(HeldThings, AreNotApartFromTheHand) {
  SquareAtHand scene;
  scene.showFor(HeldThings::kWindow, area(0.40, 0.0, 0.70, 0.3));
  EXPECT_EQ(scene.held.extent()[0], 0.0);
}

TEST(HeldThings, StandingOnTheFloorMustMoveWithTheHand) {
  const double floor = SquareAtHand().hand(Vector3d::Zero()).z();
  const Eigen::AlignedBox2d post = area(0.10, 0.05 - floor, 0.30, 0.10);
  const Vector3d aside = 0.2 * Vector3d::UnitY();
  SquareAtHand scene;
  scene.showFor(2 * HeldThings::kWindow, post);
  EXPECT_EQ(scene.held.extent()[0], 0.0);
  scene.show(post, 0.8 * aside, Vector3d::Zero());
  EXPECT_EQ(scene.held.extent()[0], 0.0);
  scene.showFor(HeldThings::kNoticed, post, aside);
  EXPECT_GT(scene.held.extent()[0], 0.0);
}

TEST(HeldThings, KnownAtTheStartAreThereAtOnce) {
  SquareAtHand scene({0.3, 0.0});
  EXPECT_DOUBLE_EQ(scene.held.extent()[0], 0.3);
  scene.showFor(1, kBox);
  EXPECT_GE(scene.held.extent()[0], 0.3);
}

TEST(HeldThings, AllocateNothingAfterTheFirstImage) {
  SquareAtHand scene;
  scene.showFor(1, kBox);
  testing::NoAlloc guard;
  scene.showFor(3, kBox);
  EXPECT_EQ(guard.count(), 0);
}

}  // namespace held_things_test
}  // namespace abstand::tracking
