// What the engine computes with, of a sphere, against closed forms.
#include "app/studio/inside_of_body.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace abstand::studio {
namespace inside_of_body_test {

constexpr double kRadius = 0.1;     // m
constexpr float kRounding = 1e-5F;  // m

TEST(InsideOfBody, OfASphere) {
  const auto shared =
      structure::buildHapticStructure("ball", geometry::makeSurface(geometry::Sphere{kRadius}),
                                      {.voxel_size = 0.01, .point_spacing = 0.01}, 1);
  const structure::HapticStructure& built = *shared;
  const ui::BodyInside inside = insideOf(built);
  ASSERT_EQ(inside.points.size(), built.shell.size());
  for (const Vector3f& p : inside.points) EXPECT_NEAR(p.norm(), kRadius, built.errorBound());
  ASSERT_FALSE(inside.levels.empty());
  ASSERT_EQ(inside.levels[0].size(), 1U);
  for (const auto& level : inside.levels) {
    EXPECT_LE(level.size(), ui::BodyInside::kMaxSpheres);
    for (const Vector3f& p : inside.points) {
      bool covered = false;
      for (const auto& sphere : level) covered |= (p - sphere.centre).norm() <= sphere.radius + kRounding;
      EXPECT_TRUE(covered) << "each level holds all points";
    }
  }
  ASSERT_EQ(inside.slice.distance.size(), static_cast<std::size_t>(inside.slice.rows * inside.slice.columns));
  int known = 0;
  for (int row = 0; row < inside.slice.rows; ++row)
    for (int column = 0; column < inside.slice.columns; ++column) {
      const float d = inside.slice.distance[static_cast<std::size_t>(row * inside.slice.columns + column)];
      if (std::isnan(d)) continue;
      ++known;
      const Vector3f p =
          inside.slice.corner + inside.slice.cell * Vector3f(static_cast<float>(column) + 0.5F,
                                                             static_cast<float>(row) + 0.5F, 0.0F);
      EXPECT_NEAR(d, p.norm() - kRadius, structure::nearField(built)->errorBound() + kRounding);
    }
  EXPECT_GT(known, 0);
}

}  // namespace inside_of_body_test
}  // namespace abstand::studio
