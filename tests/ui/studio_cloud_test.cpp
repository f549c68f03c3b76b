// Points of depth images in the 3D view, with real sessions of a rendered clip.
#include <algorithm>

#include "app/studio/depth_clouds.hpp"
#include "core/geometry/shape.hpp"
#include "tests/ui/studio_depth_window.hpp"
#include "ui/cloud_commands.hpp"
#include "ui/style/actions.hpp"

namespace abstand::studio {
namespace studio_cloud_test {

using ui::ActionId;
using ui::CloudPart;

struct StudioCloud : StudioDepth {
  ui::CloudCommands& clouds() { return window.clouds(); }
  bool waitsForCloud() {
    return QTest::qWaitFor([&] { return clouds().isOfMoment(); }, kLoadMs);
  }
  bool goesTo(double t) {
    window.playback().seek(t);
    return QTest::qWaitFor([&] { return std::abs(window.moment().t - t) < 1e-9; }, kLoadMs) &&
           waitsForCloud();
  }
  using DepthOutline = std::vector<Vector3f>;
  /// m, in the scene: vertices of the bodies of people as they are drawn.
  DepthOutline drawnPeople() {
    DepthOutline vertices;
    const view::SceneOutline outline =
        depth::openSession(scene_file::loadScene((folder.path() / "placed.yaml").string()), {})->outline();
    for (std::size_t i = 0; i < outline.objects.size(); ++i) {
      if (!outline.objects[i].human) continue;
      const Transform& X_WB = window.moment().objects[i].X_WB;
      for (const auto& p_B : outline.meshes[i].vertices)
        vertices.push_back(Vector3d(X_WB * p_B).cast<float>());
    }
    return vertices;
  }
  long count(CloudPart part) {
    const auto& points = clouds().cloud().points;
    return std::count_if(points.begin(), points.end(), [&](const auto& point) { return point.part == part; });
  }
};

TEST_F(StudioCloud, PointsAreThoseOfShownMoment) {
  ASSERT_TRUE(opensClip()) << problem;
  const auto stream = tracking::openDepthStream(clip);
  const tracking::DepthCamera camera = stream->camera();
  const int stride = cloudStride(camera.width, camera.height);
  EXPECT_EQ(stride, 2) << "320 x 240 has 76,800 pixels, and a quarter of them fits";
  for (const std::size_t wanted : {0u, 6u, 13u, 3u}) {
    ASSERT_TRUE(goesTo(at(wanted))) << wanted;
    ASSERT_EQ(clouds().cloud().images, std::vector<std::size_t>{wanted});
    EXPECT_EQ(window.viewport().cloudShown(), clouds().cloud().points.size());
    tracking::DepthFrame frame;
    stream->seek(wanted);
    ASSERT_TRUE(stream->next(frame));
    // Each measured pixel of the grid, and no other, in its place.
    std::size_t next = 0;
    constexpr double kSingle = 1e-6;  // m, rounding of a single-precision coordinate of a few metres
    for (int v = stride / 2; v < camera.height; v += stride)
      for (int u = stride / 2; u < camera.width; u += stride) {
        const auto z = static_cast<double>(frame.image.at(u, v));
        if (!(z > 0.0)) continue;
        ASSERT_LT(next, clouds().cloud().points.size());
        const Vector3d p_W = camera.X_WC * camera.at(u, v, z);
        EXPECT_LT((clouds().cloud().points[next++].p_W.cast<double>() - p_W).norm(), kSingle)
            << u << ' ' << v;
      }
    EXPECT_EQ(next, clouds().cloud().points.size());
    // The clip shows a person before nothing.
    EXPECT_GT(count(CloudPart::kPerson), 0.9 * static_cast<double>(next));
    EXPECT_EQ(count(CloudPart::kRobot), 0);
  }
}

TEST_F(StudioCloud, SwitchTakesPointsOffAndBack) {
  ASSERT_TRUE(opensClip()) << problem;
  ASSERT_TRUE(goesTo(at(5)));
  ASSERT_GT(window.viewport().cloudShown(), 100u);
  window.actions()[ActionId::kCloud]->trigger();
  EXPECT_EQ(window.viewport().cloudShown(), 0u);
  window.actions()[ActionId::kCloud]->trigger();
  ASSERT_TRUE(waitsForCloud());
  EXPECT_EQ(window.viewport().cloudShown(), clouds().cloud().points.size());
}

TEST_F(StudioCloud, PausedClockHidesPointsOfAnotherImage) {
  ASSERT_TRUE(opensClip()) << problem;
  ASSERT_TRUE(goesTo(at(5)));
  std::filesystem::remove_all(clip);
  window.playback().seek(at(9));
  ASSERT_TRUE(QTest::qWaitFor([&] { return std::abs(window.moment().t - at(9)) < 1e-9; }, kLoadMs));
  EXPECT_EQ(window.viewport().cloudShown(), 0u) << "at once, before anything is read";
  ASSERT_TRUE(waitsForCloud());
  EXPECT_FALSE(clouds().cloud().problem.isEmpty());
  EXPECT_EQ(window.viewport().cloudShown(), 0u);
}

TEST_F(StudioCloud, OtherSceneHasNoPoints) {
  ASSERT_TRUE(opensClip()) << problem;
  ASSERT_TRUE(goesTo(at(5)));
  ASSERT_GT(window.viewport().cloudShown(), 100u);
  ASSERT_TRUE(opens([&] { window.openFile(in("walk.csv")); })) << problem;
  EXPECT_EQ(window.viewport().cloudShown(), 0u);
  EXPECT_FALSE(clouds().isOfMoment());
}

/// A person who stands elsewhere than in the clip takes the points along.
TEST_F(StudioCloud, PointsStandOnDrawnPerson) {
  folder.write("placed.yaml",
               "abstand: 1\ndefaults: {voxel: 0.1, point: 0.1}\nhumans:\n  - {name: anna, recording: {file: "
               "walk.csv, place: {xyz: [0.5, -0.2, 0.1], yaw: 0.8}}}\n");
  ASSERT_TRUE(opens([&] { window.openFile(in("placed.yaml")); })) << problem;
  ASSERT_TRUE(opensClip()) << problem;
  ASSERT_TRUE(goesTo(at(12)));
  const DepthOutline shown = drawnPeople();
  std::vector<double> distances;
  for (const ui::CloudPoint& point : clouds().cloud().points) {
    if (point.part != CloudPart::kPerson) continue;
    double least = kInfinity;
    for (const Vector3f& p_W : shown) least = std::min(least, static_cast<double>((p_W - point.p_W).norm()));
    distances.push_back(least);
  }
  ASSERT_GT(distances.size(), 500u);
  std::nth_element(distances.begin(), distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2),
                   distances.end());
  // The fit and the model's parts differ from the skin, and vertices are apart.
  constexpr double kMedian = 0.05;  // m
  EXPECT_LT(distances[distances.size() / 2], kMedian);
}

/// A camera before a wall at 3 m, and a cube of 0.4 m whose front is at 2 m, in the middle of the image.
TEST(DepthCloud, PointsOfKnownBoxAreRobots) {
  constexpr double kFront = 2.0, kHalf = 0.2, kWall = 3.0;  // m
  tracking::FittedClip clip;
  clip.camera = {.width = 100, .height = 80, .fx = 100.0, .fy = 100.0, .cx = 49.5, .cy = 39.5};
  clip.camera.X_WC = tracking::lookingAt({1.0, 2.0, 1.5}, {4.0, 3.0, 1.0});
  clip.times = {0.0};
  clip.images.resize(1);
  tracking::DepthImage depth(100, 80);
  long in_box = 0;
  for (int v = 0; v < 80; ++v)
    for (int u = 0; u < 100; ++u) {
      const Vector3d p = clip.camera.at(u, v, kFront);
      const bool box = std::abs(p.x()) < kHalf && std::abs(p.y()) < kHalf;
      in_box += box;
      depth.at(u, v) = static_cast<float>(box ? kFront : kWall);
    }
  EXPECT_EQ(in_box, 400) << "2 * 0.2 m * 100 px / 2 m = 20 px wide and high";
  DepthPerson person{"anna", std::make_shared<const tracking::FittedClip>(clip), 1.0,
                     fromXyzRpy(Vector3d(0.5, -1.0, 0.0), Vector3d(0, 0, 0.7))};
  const geometry::TriangleMesh cube =
      geometry::tessellate(geometry::Cuboid{Vector3d::Constant(2.0 * kHalf)}, 1e-3);
  Transform X_WB = person.X_WR * clip.camera.X_WC;
  X_WB.translate(Vector3d(0, 0, kFront + kHalf));
  const auto points = cloudOf({&person}, 0, depth, {{&cube, X_WB}});
  ASSERT_EQ(points.size(), 8000u);
  long robots = 0;
  for (const ui::CloudPoint& point : points) {
    const Vector3d p_C = (person.X_WR * clip.camera.X_WC).inverse() * point.p_W.cast<double>();
    EXPECT_EQ(point.part == CloudPart::kRobot, p_C.z() < 2.5) << p_C.transpose();
    robots += point.part == CloudPart::kRobot;
  }
  EXPECT_EQ(robots, in_box);
  // Without the robot there, the same points are of the background.
  for (const ui::CloudPoint& point : cloudOf({&person}, 0, depth, {}))
    EXPECT_EQ(point.part, CloudPart::kBackground);
}

TEST(DepthCloud, StrideKeepsWithinLimit) {
  EXPECT_EQ(cloudStride(160, 120), 1);
  EXPECT_EQ(cloudStride(512, 424), 3);
  EXPECT_EQ(cloudStride(640, 480), 4);
  for (const int width : {1, 511, 640, 1920, 4096})
    for (const int height : {1, 424, 1080, 4096}) {
      const int stride = cloudStride(width, height);
      EXPECT_LE(static_cast<long>(width / stride) * (height / stride), kMaxCloudPoints);
    }
}

TEST(DepthCloud, ColoursTellPartsAndConfidence) {
  const ui::CloudPoint person{{}, CloudPart::kPerson, ui::JointLook::kInferred};
  const ui::CloudPoint robot{{}, CloudPart::kRobot, {}}, other;
  using ui::CloudColours;
  EXPECT_NE(colourOf(person, CloudColours::kParts), colourOf(robot, CloudColours::kParts));
  EXPECT_NE(colourOf(other, CloudColours::kParts), colourOf(robot, CloudColours::kParts));
  EXPECT_EQ(colourOf(person, CloudColours::kConfidence), ui::colourOf(ui::JointLook::kInferred));
  EXPECT_EQ(colourOf(robot, CloudColours::kConfidence), colourOf(other, CloudColours::kConfidence));
}

}  // namespace studio_cloud_test
}  // namespace abstand::studio
