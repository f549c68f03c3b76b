// A ball that a server moves, in the view of a camera: where the server has it, and only while it knows.
#include "app/live_depth/served_things.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/error.hpp"
#include "tests/app/viewer/served_ball.hpp"

namespace abstand::live_depth {
namespace served_things_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr double kAway = 2.0, kRadius = 0.1;  // m, of the camera from the slide; of the ball
constexpr double kRounding = 1e-3;            // m, of the ball's mesh

/// At (2, 0, 0.5), looking horizontally at the slide; a pixel has 1 cm there.
tracking::DepthCamera lookingAtTheSlide() {
  tracking::DepthCamera camera;
  camera.width = 160;
  camera.height = 120;
  camera.fx = camera.fy = 200.0;
  camera.cx = 80.0;
  camera.cy = 60.0;
  camera.X_WC = tracking::lookingAt({kAway, 0.0, 0.5}, {0.0, 0.0, 0.5});
  return camera;
}

struct ServedThingsTest : ::testing::Test, testing::ServedBall {
  std::unique_ptr<ServedThings> openThings() {
    return std::make_unique<ServedThings>(file.string(), description(), options, host->address());
  }
  /// Depth (m) at the slide at height `z` (m); 0: nothing is rendered.
  double depthAt(ServedThings& things, double z) {
    things.update(viewer::steadySeconds());
    const tracking::DepthImage* image = things.at(camera);
    return image ? static_cast<double>(image->at(80, static_cast<int>(60.0 - 100.0 * (z - 0.5)))) : 0.0;
  }
  /// The ball stays at this height, also for longer than the window.
  bool isAt(ServedThings& things, double z) {
    for (const double until = now() + testing::kAllowance; now() < until;) {
      cycle(z);
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
      if (depthAt(things, z) > 0.0 && depthAt(things, z - 2.0 * kRadius) == 0.0 &&
          depthAt(things, z + 2.0 * kRadius) == 0.0)
        return true;
    }
    return false;
  }
  /// Cycles of a server that gets no joint values.
  void idle() {
    scene->cycle(now());
    host->look(now(), ++cycles, *scene);
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  std::vector<std::string> newsWithin(ServedThings& things, const std::function<void()>& meanwhile) {
    for (const double until = now() + testing::kAllowance; now() < until;) {
      meanwhile();
      things.update(viewer::steadySeconds());
      if (auto news = things.news(); !news.empty()) return news;
    }
    return {};
  }
  scene_file::SceneDescription description() const {
    return scene_file::parseScene(testing::kServedBall, file);
  }
  const session::SessionOptions options{.cache = false};
  tracking::DepthCamera camera = lookingAtTheSlide();
};

TEST_F(ServedThingsTest, BallIsWhereTheServerHasIt) {
  const auto things = openThings();
  ASSERT_TRUE(isAt(*things, 0.4));
  EXPECT_NEAR(depthAt(*things, 0.4), kAway - kRadius, kRounding);
  EXPECT_GT(depthAt(*things, 0.0), 0.0) << "the plate, which no mechanism moves";
  ASSERT_TRUE(isAt(*things, 0.7));
  EXPECT_NEAR(depthAt(*things, 0.7), kAway - kRadius, kRounding);
  EXPECT_THAT(things->news(), IsEmpty());
}

TEST_F(ServedThingsTest, BallAtRestIsRenderedAlone) {
  const auto things = openThings();
  ASSERT_TRUE(isAt(*things, 0.4));
  const auto shown = [](const tracking::DepthImage* image) {
    return std::count_if(image->z.begin(), image->z.end(), [](float z) { return z > 0.0f; });
  };
  const auto ball = shown(things->atRest(camera));
  EXPECT_NEAR(static_cast<double>(ball), 314.0, 30.0) << "the disc, without the plate";
  EXPECT_GT(shown(things->at(camera)), ball);
  EXPECT_TRUE(runUntil([&] {
    things->update(viewer::steadySeconds());
    return shown(things->atRest(camera)) == 0;
  })) << "it moves: it is not compared with one of its places";
}

TEST_F(ServedThingsTest, MovingBallIsEverywhereItWasLately) {
  const auto things = openThings();
  const auto rows = [&] {
    int count = 0;
    for (int k = 20; k < 95; ++k) count += depthAt(*things, 0.01 * k) > 0.0;
    return count;
  };
  ASSERT_TRUE(isAt(*things, 0.4));
  const int at_rest = rows();
  EXPECT_NEAR(at_rest, 20, 2) << "the diameter";
  int most = 0;
  EXPECT_TRUE(runUntil([&] { return (most = std::max(most, rows())) > at_rest + 3; })) << most;
  ASSERT_TRUE(isAt(*things, 0.4));
  EXPECT_EQ(rows(), at_rest);
}

TEST_F(ServedThingsTest, StaleJointValuesAreSaidAndNothingIsRendered) {
  const auto things = openThings();
  ASSERT_TRUE(isAt(*things, 0.4));
  EXPECT_THAT(newsWithin(*things, [&] { idle(); }),
              ElementsAre("slide is not removed from the images: its joint values are stale"));
  EXPECT_EQ(depthAt(*things, 0.4), 0.0);
  EXPECT_GT(depthAt(*things, 0.0), 0.0) << "the plate is where it was";
  EXPECT_THAT(newsWithin(*things, [&] { cycle(0.4); }),
              ElementsAre("slide is removed from the images: its joint values are known"));
  EXPECT_GT(depthAt(*things, 0.4), 0.0);
}

TEST_F(ServedThingsTest, SilentServerIsSaidAndNothingIsKnown) {
  const auto things = openThings();
  ASSERT_TRUE(isAt(*things, 0.4));
  host.reset();
  const auto wait = [] { std::this_thread::sleep_for(std::chrono::milliseconds(10)); };
  EXPECT_THAT(newsWithin(*things, wait), ElementsAre(HasSubstr("does not answer")));
  EXPECT_EQ(things->at(camera), nullptr);
}

TEST_F(ServedThingsTest, OtherScenesAreRefused) {
  const auto other = folder.write("other.yaml", std::string(testing::kServedBall) + "\n");
  try {
    ServedThings(other.string(), description(), options, host->address());
    FAIL() << "the files differ";
  } catch (const UsageError& e) {
    EXPECT_THAT(e.what(), HasSubstr("another scene"));
  }
  EXPECT_THROW(ServedThings(file.string(), description(), options, std::nullopt), UsageError)
      << "a mechanism";
}

TEST_F(ServedThingsTest, ObjectsAloneNeedNoServer) {
  scene_file::SceneDescription alone = description();
  alone.mechanisms.clear();
  ServedThings things(file.string(), alone, options, std::nullopt);
  EXPECT_GT(depthAt(things, 0.0), 0.0);
  EXPECT_EQ(depthAt(things, 0.4), 0.0);
}

}  // namespace served_things_test
}  // namespace abstand::live_depth
