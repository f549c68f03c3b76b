// Bodies of skin: closed, as thick as asked, and around their bones.
#include "tracking/depth/simulator/skin_body.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.hpp"
#include "core/mesh_file/mesh_report.hpp"
#include "tests/humanmodel/skeletons.hpp"
#include "tracking/depth/simulator/depth_render.hpp"
#include "tracking/depth/simulator/skin_loft.hpp"

namespace abstand::testing {
namespace skin_body_test {

using enum humanmodel::Joint;

constexpr double kStature = 1.62;    // m, of walking()
constexpr double kRounding = 1e-12;  // m

const geometry::TriangleMesh& part(const std::vector<tracking::SkinPart>& parts, std::string_view name) {
  for (const tracking::SkinPart& p : parts)
    if (p.name == name) return p.mesh;
  throw std::runtime_error("no part " + std::string(name));
}

TEST(SkinLoft, CurveInterpolatesPointsMonotonically) {
  const std::vector<tracking::CurvePoint> points{{0.0, 1.0}, {0.3, 2.0}, {0.4, 2.1}, {1.0, -1.0}};
  for (const tracking::CurvePoint& p : points) EXPECT_DOUBLE_EQ(tracking::smoothCurve(points, p.x), p.y);
  EXPECT_EQ(tracking::smoothCurve(points, -5.0), 1.0);
  EXPECT_EQ(tracking::smoothCurve(points, 5.0), -1.0);
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    const double sign = points[k + 1].y > points[k].y ? 1.0 : -1.0;
    double last = points[k].y;
    for (int i = 1; i <= 100; ++i) {
      const double y = tracking::smoothCurve(points, points[k].x + (points[k + 1].x - points[k].x) * i / 100);
      EXPECT_GE(sign * (y - last), -kRounding) << k << " " << i;
      last = y;
    }
  }
}

TEST(SkinBody, IsClosedAndFacesOutwards) {
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    const tracking::SkinBody skin(kStature, {1.0 + 0.1 * static_cast<double>(seed), 0.01, seed});
    for (double t = 0.0; t < 2.0; t += 0.37) {
      const auto parts = skin.wrap(walking(t));
      EXPECT_EQ(parts.size(), 15u);
      for (const tracking::SkinPart& p : parts)
        EXPECT_TRUE(mesh_file::inspect(p.mesh).watertight) << p.name << " " << seed << " " << t;
    }
  }
}

TEST(SkinBody, CoversJointsFromAllSides) {
  tracking::DepthCamera camera;
  const tracking::SkinBody skin(kStature, {});
  for (double t = 0.0; t < 2.0; t += 0.41) {
    const humanmodel::SkeletonFrame frame = walking(t);
    for (int view = 0; view < 8; ++view) {
      const double a = 2.0 * kPi * view / 8;
      camera.X_WC = tracking::lookingAt({2.6 * std::cos(a), 2.6 * std::sin(a), 1.2}, {0.0, 0.0, 0.8});
      tracking::DepthRender render(camera);
      for (const tracking::SkinPart& p : skin.wrap(frame)) render.draw(p.mesh, camera.X_WC.inverse());
      for (std::size_t j = 0; j < humanmodel::kJointCount; ++j) {
        const Vector3d p = camera.X_WC.inverse() * frame.p[j];
        const float z =
            render.image().at(static_cast<int>(std::lround(camera.fx * p.x() / p.z() + camera.cx)),
                              static_cast<int>(std::lround(camera.fy * p.y() / p.z() + camera.cy)));
        EXPECT_GT(z, 0.0f) << humanmodel::jointName(static_cast<humanmodel::Joint>(j)) << " " << view << " "
                           << t;
        EXPECT_LT(z, p.z()) << humanmodel::jointName(static_cast<humanmodel::Joint>(j)) << " " << view << " "
                            << t;
      }
    }
  }
}

TEST(SkinBody, ClothingCoversLimbsNotHeadAndHands) {
  const humanmodel::SkeletonFrame frame = walking(0.3);
  constexpr double kClothing = 0.017;  // m
  const auto bare = tracking::SkinBody(kStature, {}).wrap(frame),
             dressed = tracking::SkinBody(kStature, {1.0, kClothing}).wrap(frame);
  ASSERT_EQ(bare.size(), dressed.size());
  for (const char* name : {"biceps_left", "forearm_right", "thigh_left", "calf_right"}) {
    const geometry::TriangleMesh &a = part(bare, name), &b = part(dressed, name);
    double most = 0.0;
    for (std::size_t i = 0; i < a.vertices.size(); ++i)
      most = std::max(most, (b.vertices[i] - a.vertices[i]).norm());
    EXPECT_NEAR(most, kClothing, kRounding) << name;
  }
  for (const char* name : {"head", "neck", "hand_left", "foot_right"})
    EXPECT_EQ(part(bare, name).vertices, part(dressed, name).vertices) << name;
  EXPECT_GT(mesh_file::inspect(part(dressed, "torso")).volume,
            mesh_file::inspect(part(bare, "torso")).volume);
}

TEST(SkinBody, HasRequestedGirth) {
  const humanmodel::SkeletonFrame frame = walking(0.3);
  const Vector3d hip = frame[kHipLeft], axis = (frame[kKneeLeft] - hip).normalized();
  for (const double girth : {0.8, 1.0, 1.3}) {
    const auto parts = tracking::SkinBody(kStature, {girth}).wrap(frame);
    double most = 0.0;
    for (const Vector3d& p : part(parts, "thigh_left").vertices)
      most = std::max(most, (p - hip).cross(axis).norm());
    EXPECT_NEAR(most, 0.052 * girth * kStature, kRounding);  // the thigh's share of stature
  }
}

TEST(SkinBody, IsReproducibleForSameSeed) {
  const humanmodel::SkeletonFrame frame = walking(1.1);
  const auto wrap = [&](std::uint64_t seed) {
    return tracking::SkinBody(kStature, {1.0, 0.0, seed}).wrap(frame);
  };
  const auto usual = wrap(0), one = wrap(1), again = wrap(1), two = wrap(2);
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].mesh.vertices, again[i].mesh.vertices);
    EXPECT_NE(one[i].mesh.vertices, two[i].mesh.vertices) << one[i].name;
    const double volume = mesh_file::inspect(usual[i].mesh).volume;
    EXPECT_NEAR(mesh_file::inspect(one[i].mesh).volume, volume, 0.25 * volume) << one[i].name;  // 1.08 cubed
  }
}

TEST(SkinBody, OmitsPartsOfMissingJoints) {
  humanmodel::SkeletonFrame frame = walking(0.0);
  drop(frame, kWristLeft);
  drop(frame, kHeadTop);
  const auto parts = tracking::SkinBody(kStature, {}).wrap(frame);
  EXPECT_EQ(parts.size(), 15u - 4u);
  for (const char* name : {"forearm_left", "hand_left", "head", "neck"})
    EXPECT_THROW(part(parts, name), std::runtime_error);
  EXPECT_TRUE(tracking::SkinBody(kStature, {}).wrap(humanmodel::SkeletonFrame{}).empty());
}

TEST(SkinBody, RejectsOutOfRangeValues) {
  EXPECT_THROW(tracking::SkinBody(0.1, {}), UsageError);
  EXPECT_THROW(tracking::SkinBody(kNaN, {}), UsageError);
  EXPECT_THROW(tracking::SkinBody(kStature, {5.0}), UsageError);
  EXPECT_THROW(tracking::SkinBody(kStature, {1.0, -0.01}), UsageError);
}

TEST(SkinBody, LegsDetermineStature) {
  const std::vector<humanmodel::SkeletonFrame> frames{humanmodel::SkeletonFrame{}, walking(0.1, 1.62),
                                                      walking(0.2, 1.62)};
  // The model's legs are those of other people than Drillis's and Contini's.
  EXPECT_NEAR(tracking::statureOfLegs(frames).value(), 1.62, 0.06);
  EXPECT_FALSE(tracking::statureOfLegs(std::span(frames).first(1)).has_value());
}

}  // namespace skin_body_test
}  // namespace abstand::testing
