// Pixels of a post beside a person: static, apart from the body, and judged once the knees have moved.
#include "tracking/tracker/still_things.hpp"

#include <gtest/gtest.h>

#include "tests/support/no_alloc.hpp"
#include "tests/tracking/tracker/seated_pose.hpp"
#include "tests/tracking/tracker/small_camera.hpp"
#include "tests/tracking/tracker/upright_person.hpp"

namespace abstand::tracking {
namespace still_things_test {

constexpr float kPost = 2.2f, kShin = 2.4f, kWall = 4.0f;  // m
constexpr double kBeyondLegMoved = 1.2 * StillThings::kLegMoved;

/// A person 2.5 m ahead of the camera. The pixels assigned to the person show a post 1 m beside the body.
struct PostBeside {
  BodyRig rig = makeRig(humanmodel::makeHuman({}));
  DepthFit fit{rig};
  DepthCamera camera = smallCamera();
  DepthImage image;
  std::vector<std::uint8_t> is_person;
  BodyObservation seen;
  StillThings things;

  PostBeside() {
    image = DepthImage(camera.width, camera.height);
    is_person.assign(image.z.size(), 0);
  }
  bool isPost(std::size_t i) const {
    const auto width = static_cast<std::size_t>(image.width);
    return i % width >= 140 && i % width < 146 && i / width >= 80 && i / width < 110;
  }
  std::size_t postPixels() const { return 6 * 30; }
  RigPlacement placed(const Vector3d& moved) const { return uprightAt(rig, moved); }
  /// Shows the post at a depth of `post` (m).
  void look(float post) {
    for (std::size_t i = 0; i < image.z.size(); ++i) {
      is_person[i] = isPost(i);
      image.z[i] = is_person[i] ? post : kWall;
    }
    const PersonImage person{&image, &camera, is_person};
    const std::span<const PersonImage> left = things.remove({&person, 1});
    seen.update(left);
  }
  /// And learns from the person.
  void show(float post, const Vector3d& moved) {
    look(post);
    things.learn(seen, fit, placed(moved));
  }
  void show(float post, double moved) { show(post, moved * Vector3d::UnitX()); }
  void showFor(int images, float post, double moved) {
    for (int k = 0; k < images; ++k) show(post, moved);
  }
  /// The person walks away by kBeyondLegMoved.
  void walk(float post) {
    for (const double share : {0.25, 0.5, 0.75, 1.0, 1.0}) show(post, share * kBeyondLegMoved);
  }
};

TEST(StillThings, ArePixelsApartFromABodyWhoseKneesHaveMoved) {
  PostBeside scene;
  scene.showFor(StillThings::kApartImages, kPost, 0.0);
  EXPECT_EQ(scene.things.removed(), 0u);
  scene.walk(kPost);
  EXPECT_EQ(scene.things.removed(), scene.postPixels());
}

TEST(StillThings, AreKnownByTheNumberOfTheirCamera) {
  PostBeside scene;
  scene.showFor(StillThings::kApartImages, kPost, 0.0);
  scene.walk(kPost);
  const DepthCamera copy = scene.camera;
  const PersonImage of_copy{&scene.image, &copy, scene.is_person, 0};
  scene.things.remove({&of_copy, 1});
  EXPECT_EQ(scene.things.removed(), scene.postPixels());
  const PersonImage of_other{&scene.image, &scene.camera, scene.is_person, 1};
  scene.things.remove({&of_other, 1});
  EXPECT_EQ(scene.things.removed(), 0u);
}

TEST(StillThings, AreNoneBesideAPersonWhoStandsStill) {
  PostBeside scene;
  scene.showFor(10 * StillThings::kApartImages, kPost, 0.0);
  scene.showFor(10 * StillThings::kApartImages, kPost, 0.8 * StillThings::kLegMoved);
  EXPECT_EQ(scene.things.removed(), 0u);
}

TEST(StillThings, AreNoneIfTheyWereApartInFewImages) {
  PostBeside scene;
  const std::array shares{0.3, 0.6, 0.9, 1.0};
  static_assert(shares.size() < StillThings::kApartImages);
  for (const double share : shares) scene.show(kPost, share * kBeyondLegMoved);
  scene.show(kPost, kBeyondLegMoved);
  EXPECT_EQ(scene.things.removed(), 0u);
}

TEST(StillThings, AreNoneIfTheBodyJumps) {
  PostBeside scene;
  scene.showFor(StillThings::kApartImages, kPost, 0.0);
  scene.showFor(StillThings::kApartImages - 1, kPost, kBeyondLegMoved);
  EXPECT_EQ(scene.things.removed(), 0u);
}

TEST(StillThings, AreNoneIfTheBodyExplainsThem) {
  PostBeside scene;
  // The left calf, which has a radius of 5 cm, is at the post; then the person steps away sideways.
  const Vector3d p_W = scene.camera.X_WC * scene.camera.at(142.5, 95.0, kPost);
  const Vector3d calf = scene.placed(Vector3d::Zero())[index(RigSegment::kCalfLeft)].translation();
  const Vector3d there(p_W.x() - calf.x() - 0.05, p_W.y() - calf.y(), 0.0);
  for (int k = 0; k < 3 * StillThings::kApartImages; ++k) scene.show(kPost, there);
  for (const double share : {0.25, 0.5, 0.75, 1.0, 1.0})
    scene.show(kPost, Vector3d(there + share * kBeyondLegMoved * Vector3d::UnitY()));
  EXPECT_EQ(scene.things.removed(), 0u);
}

TEST(StillThings, LeaveWhatIsBeforeThemToThePerson) {
  PostBeside scene;
  scene.showFor(StillThings::kApartImages, kPost, 0.0);
  scene.walk(kPost);
  scene.show(kPost - 0.1f, kBeyondLegMoved);
  EXPECT_EQ(scene.things.removed(), 0u);
  scene.show(kPost, kBeyondLegMoved);
  EXPECT_EQ(scene.things.removed(), scene.postPixels()) << "remembered while hidden";
}

TEST(StillThings, AreForgottenWhereTheCameraLooksPastThem) {
  PostBeside scene;
  scene.showFor(StillThings::kApartImages, kPost, 0.0);
  scene.walk(kPost);
  scene.showFor(8, kShin, kBeyondLegMoved);
  scene.show(kPost, kBeyondLegMoved);
  EXPECT_EQ(scene.things.removed(), 0u);
}

/// The post is behind the back of somebody who sits, facing +x across the view of the camera.
struct ChairSeen : PostBeside {
  RigPlacement seated() const {
    RigPlacement X_WS = seatedPlacement(rig);
    const Vector3d post = camera.X_WC * camera.at(142.5, 95.0, kPost);
    const Vector3d back = X_WS[index(RigSegment::kPelvis)].translation() - 0.25 * Vector3d::UnitX();
    const Vector3d by(post.x() - back.x(), post.y() - back.y(), 0.0);
    for (Transform& X : X_WS) X.pretranslate(by);
    return X_WS;
  }
  void sit(int images) {
    for (int k = 0; k < images; ++k) {
      look(kPost);
      things.learn(seen, fit, seated());
    }
  }
  std::size_t removedNext() {
    look(kPost);
    return things.removed();
  }
};

TEST(StillThings, ChairIsOneInTheNextPassOnly) {
  ChairSeen scene;
  ASSERT_TRUE(ChairSpace::of(scene.rig, scene.seated())
                  ->holds(scene.camera.X_WC * scene.camera.at(142.5, 95.0, kPost)));
  scene.sit(StillThings::kChairImages);
  EXPECT_EQ(scene.removedNext(), 0u);
  scene.things.keepChair();
  EXPECT_EQ(scene.removedNext(), scene.postPixels());
  scene.things.forget();
  scene.things.forgetChair();
  EXPECT_EQ(scene.removedNext(), scene.postPixels()) << "kept";
}

TEST(StillThings, ChairIsNoneAfterFewImagesOrWrongPoses) {
  ChairSeen scene;
  scene.sit(StillThings::kChairImages - 1);
  scene.things.keepChair();
  EXPECT_EQ(scene.removedNext(), 0u) << "few images";
  for (const bool facing : {false, true}) {
    ChairSeen other;
    other.sit(StillThings::kChairImages);
    facing ? other.things.forgetChair() : other.things.forget();
    other.things.keepChair();
    EXPECT_EQ(other.removedNext(), 0u) << facing;
  }
}

TEST(StillThings, OfWrongPosesAreForgotten) {
  PostBeside scene;
  scene.showFor(StillThings::kApartImages, kPost, 0.0);
  scene.walk(kPost);
  ASSERT_EQ(scene.things.removed(), scene.postPixels());
  scene.things.forget();
  scene.show(kPost, kBeyondLegMoved);
  EXPECT_EQ(scene.things.removed(), 0u);
}

TEST(StillThings, AllocateNothingAfterTheFirstImage) {
  PostBeside scene;
  scene.show(kPost, 0.0);
  testing::NoAlloc guard;
  scene.showFor(2 * StillThings::kApartImages, kPost, 0.0);
  EXPECT_EQ(guard.count(), 0);
}

}  // namespace still_things_test
}  // namespace abstand::tracking
