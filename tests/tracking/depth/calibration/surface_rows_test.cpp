// Normal equations of surfaces, and surfaces on rays.
#include "tracking/depth/calibration/surface_rows.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>

#include "tracking/depth/calibration/surface_ray.hpp"

namespace abstand::testing {
namespace surface_rows_test {

/// Rows on three faces of a cube of 0.4 m, with normally distributed distances.
std::vector<tracking::SurfaceRow> cubeRows(std::mt19937_64& random, std::size_t count, double noise) {
  std::uniform_real_distribution<double> side(-0.2, 0.2);
  std::normal_distribution<double> normal(0.0, noise);
  std::vector<tracking::SurfaceRow> rows;
  for (std::size_t i = 0; i < count; ++i) {
    tracking::SurfaceRow row;
    const auto axis = static_cast<Eigen::Index>(i % 3);
    row.p_W = Vector3d(side(random), side(random), side(random));
    row.p_W[axis] = 0.2;
    row.n_W = Vector3d::Unit(axis);
    row.distance = normal(random);
    rows.push_back(row);
  }
  return rows;
}

/// The steps to the minimum; the rows are then those there.
tracking::Vector6d solve(std::vector<tracking::SurfaceRow>& rows) {
  tracking::Vector6d all = tracking::Vector6d::Zero();
  for (int i = 0; i < 20; ++i) {
    const tracking::SurfaceSum sum = tracking::sumOf(rows);
    const tracking::Vector6d step = *tracking::stepOf(sum);
    all += step;
    for (tracking::SurfaceRow& row : rows)
      row.distance += row.n_W.dot(step.head<3>() + step.tail<3>().cross(row.p_W - sum.middle));
  }
  return all;
}

TEST(SurfaceRows, CovarianceMatchesMonteCarlo) {
  std::mt19937_64 random(1);
  constexpr int kSets = 600;
  constexpr double kNoise = 0.01;  // m
  // Whose robust weights lose much of few rows.
  for (const std::size_t count : {30u, 300u}) {
    double translations = 0.0, rotations = 0.0, stated_translations = 0.0, stated_rotations = 0.0;
    for (int i = 0; i < kSets; ++i) {
      auto rows = cubeRows(random, count, kNoise);
      const tracking::Vector6d step = solve(rows);
      translations += step.head<3>().squaredNorm();
      rotations += step.tail<3>().squaredNorm();
      const tracking::Matrix6d covariance = tracking::covarianceOf(tracking::sumOf(rows));
      stated_translations += covariance.topLeftCorner<3, 3>().trace();
      stated_rotations += covariance.bottomRightCorner<3, 3>().trace();
    }
    // 600 sets of three axes: their mean square is within 10 % (three standard deviations); the formula is
    // that of many rows.
    const double tolerance = count < 100 ? 0.2 : 0.1;
    EXPECT_NEAR(stated_translations / translations, 1.0, tolerance) << count;
    EXPECT_NEAR(stated_rotations / rotations, 1.0, tolerance) << count;
  }
}

TEST(SurfaceRows, CovarianceOfTooFewRowsIsInfinite) {
  std::mt19937_64 random(1);
  EXPECT_EQ(tracking::covarianceOf(tracking::sumOf(cubeRows(random, 6, 0.01)))(0, 0), kInfinity);
}

TEST(SurfaceRay, MeetsFirstSurfaceThatFacesCamera) {
  constexpr double kTolerance = 1e-6;  // m, of Newton's method
  // The normal is that of the last step but one, up to 0.1 mm from a ball of 0.1 m.
  constexpr double kNormalTolerance = 4e-3;
  const auto ball = geometry::makeSurface(geometry::Sphere{0.1});
  const Vector3d ray = Vector3d(0.2, -0.1, 1.0).normalized();
  for (const double off : {0.0, 0.03, 0.06})
    for (const double noise : {-0.1, -0.02, 0.0, 0.05, 0.15}) {
      // A line at the distance `off` from the centre: it enters sqrt(r^2 - off^2) before the nearest point.
      const Vector3d side = ray.unitOrthogonal();
      const double enters = -std::sqrt(0.01 - off * off);
      const tracking::RayHit hit = tracking::meet(*ball, off * side + (enters + noise) * ray, ray, 0.2);
      EXPECT_NEAR(hit.t, -noise, kTolerance) << off << ", " << noise;
      EXPECT_LT((hit.n - (off * side + enters * ray).normalized()).norm(), kNormalTolerance) << off;
    }
  EXPECT_EQ(tracking::meet(*ball, 0.11 * ray.unitOrthogonal(), ray, 0.2).t, kInfinity) << "passes by";
  EXPECT_EQ(tracking::meet(*ball, 0.09999 * ray.unitOrthogonal(), ray, 0.2).t, kInfinity) << "too flat";
  EXPECT_EQ(tracking::meet(*ball, -0.5 * ray, ray, 0.2).t, kInfinity) << "far before it";
  EXPECT_EQ(tracking::meet(*ball, 0.15 * ray, ray, 0.2).t, kInfinity) << "starts inside";
}

}  // namespace surface_rows_test
}  // namespace abstand::testing
