// The library as others see it: closed forms, and that the ways to ask agree to the bit.
#include <gtest/gtest.h>

#include <cstring>

#include "abstand/library.hpp"
#include "abstand/mechanism.hpp"
#include "abstand/query.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/random_pose.hpp"

namespace abstand {
namespace library_test {

using Eigen::Vector3d;

// m. The witness points are moved along exact surfaces, so distances of shapes are those of the shapes.
constexpr double kExact = 1e-6;
constexpr StructureOptions kCoarse{.voxel_size = 0.01, .point_spacing = 0.01};

Pose at(double x, double y, double z) {
  Pose X = Pose::Identity();
  X.translation() << x, y, z;
  return X;
}

std::vector<Pose> somePoses(int count) {
  std::vector<Pose> poses;
  for (int i = 0; i < count; ++i) poses.emplace_back(Transform(testing::randomPose(i, 0.3)));
  return poses;
}

/// All bits of a result.
bool same(const PairResult& l, const PairResult& r) {
  const auto bits = [](double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; };
  const auto all = [&](const Vector3d& a, const Vector3d& b) {
    return bits(a.x(), b.x()) && bits(a.y(), b.y()) && bits(a.z(), b.z());
  };
  return bits(l.distance, r.distance) && bits(l.bound, r.bound) && all(l.witness_a, r.witness_a) &&
         all(l.witness_b, r.witness_b) && all(l.force_a, r.force_a) && all(l.torque_a, r.torque_a) &&
         all(l.torque_b, r.torque_b) && l.contacts == r.contacts && bits(l.depth, r.depth);
}

std::string errorOf(const std::function<void()>& work) {
  try {
    work();
  } catch (const std::runtime_error& e) {
    return e.what();
  }
  return "nothing";
}

TEST(Library, TwoSpheresMatchClosedForm) {
  const Structure a = Structure::build(Shape::sphere(0.05), kCoarse);
  const Structure b = Structure::build(Shape::sphere(0.08), kCoarse);
  for (const double apart : {0.01, 0.1, 0.7}) {
    const PairResult r = queryPair(a, at(0, 0, 1), b, at(0.13 + apart, 0, 1));
    EXPECT_NEAR(r.distance, apart, 0.01 * apart + kExact);
    EXPECT_GE(r.distance, apart - kExact);
    EXPECT_LE(r.distance - r.bound, apart);
    EXPECT_NEAR(r.witness_a.x(), 0.05, 0.01);
    EXPECT_EQ(r.contacts, 0);
  }
}

TEST(Library, TwoBoxesMatchClosedForm) {
  const Structure a = Structure::build(Shape::cuboid({0.2, 0.2, 0.2}), kCoarse);
  const Structure b = Structure::build(Shape::cuboid({0.1, 0.1, 0.1}), kCoarse);
  const PairResult apart = queryPair(a, at(0, 0, 0), b, at(0.2, 0.02, 0.0));
  EXPECT_NEAR(apart.distance, 0.05, kExact);
  EXPECT_LE(apart.distance - apart.bound, 0.05);
  // k times the overlapping volume, 0.1 x 0.1 x 0.02 m^3, pushes A back along -x.
  const PairResult pressed = queryPair(a, at(0, 0, 0), b, at(0.13, 0, 0), {.stiffness = 1e6});
  EXPECT_LT(pressed.distance, 0.0);
  EXPECT_NEAR(pressed.force_a.x(), -1e6 * 0.1 * 0.1 * 0.02, 0.1 * 200);
  EXPECT_GT(pressed.contacts, 0);
}

TEST(Library, MeshMatchesShape) {
  Mesh box;  // a cube of 0.1 m, its corners not shared
  const Structure shape = Structure::build(Shape::cuboid({0.1, 0.1, 0.1}), kCoarse);
  const Mesh shared = shape.mesh();
  for (const auto& triangle : shared.triangles) {
    const auto first = static_cast<std::uint32_t>(box.vertices.size());
    for (const std::uint32_t corner : triangle) box.vertices.push_back(shared.vertices[corner]);
    box.triangles.push_back({first, first + 1, first + 2});
  }
  const Structure mesh = Structure::build(box, kCoarse, "box");
  EXPECT_TRUE(mesh.watertight());
  EXPECT_NEAR(mesh.volume(), 1e-3, 1e-9);
  EXPECT_NEAR(mesh.radius(), 0.05 * std::sqrt(3.0), 1e-9);
  EXPECT_EQ(mesh.name(), "box");
  EXPECT_EQ(mesh.options().voxel_size, kCoarse.voxel_size);
  const PairResult r = queryPair(mesh, at(0, 0, 0), shape, at(0, 0, 0.15));
  EXPECT_NEAR(r.distance, 0.05, kExact);
}

TEST(Library, BatchIsBitIdenticalToSingleQueries) {
  const Structure a = Structure::build(Shape::capsule(0.05, 0.2), kCoarse);
  const Structure b = Structure::build(Shape::ellipsoid({0.05, 0.1, 0.07}), kCoarse);
  const std::vector<Pose> X_WA{at(0.1, 0.0, 0.0)}, X_WB = somePoses(400);
  const QueryOptions options{.margin = 0.02};
  const auto one = queryPoses(a, X_WA, b, X_WB, {.query = options});
  const auto several = queryPoses(a, X_WA, b, X_WB, {.query = options, .threads = 3});
  ASSERT_EQ(one.size(), 400u);
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_TRUE(same(one[i], queryPair(a, X_WA[0], b, X_WB[i], options))) << i;
    EXPECT_TRUE(same(one[i], several[i])) << i;
  }
}

TEST(Library, SequenceIsBitIdenticalToStatefulPair) {
  const Structure a = Structure::build(Shape::capsule(0.05, 0.2), kCoarse);
  const Structure b = Structure::build(Shape::cuboid({0.1, 0.1, 0.1}), kCoarse);
  std::vector<Pose> path;
  for (int i = 0; i < 300; ++i) path.push_back(at(0.3 - 1e-3 * i, 1e-3 * i, 0.0));
  const std::vector<Pose> rest{Pose::Identity()};
  const auto one = queryPoses(a, rest, b, path, {.threads = 1, .sequence = true});
  const auto several = queryPoses(a, rest, b, path, {.threads = 4, .sequence = true});
  PairState state;
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (i % kBatchBlock == 0) state.reset();
    EXPECT_TRUE(same(one[i], queryPair(a, rest[0], b, path[i], {}, state))) << i;
    EXPECT_TRUE(same(one[i], several[i])) << i;
  }
}

/// m: of the centre of a sphere of radius r from an axis-parallel cuboid with half edges h about the origin.
double sphereToCuboid(const Vector3d& p, double r, const Vector3d& h) {
  return (p.cwiseAbs() - h).cwiseMax(0.0).norm() - r;
}

TEST(Library, WarmDistancesAreWithinTheTolerance) {
  // m: tolerance of distances up to 0.1 m; and the share by which the far field is coarser.
  constexpr double kAbsolute = 1e-5, kField = 1e-4;
  const Vector3d half(0.1, 0.05, 0.15);
  const Structure ball = Structure::build(Shape::sphere(0.05), kCoarse);
  const Structure box = Structure::build(Shape::cuboid(2.0 * half), kCoarse);
  double largest = 0.0;
  for (const double tolerance : {0.0, 0.002, 0.1}) {
    PairState state;
    for (int i = 0; i < 400; ++i) {
      const double turn = 0.05 * i, away = 0.3 + 0.001 * i;
      const Vector3d p(away * std::cos(turn), away * std::sin(turn), 0.3 * std::sin(3.0 * turn));
      const double exact = sphereToCuboid(p, 0.05, half);
      const PairResult r = queryPair(ball, at(p.x(), p.y(), p.z()), box, Pose::Identity(),
                                     {.far_tolerance = tolerance}, state);
      EXPECT_GE(r.distance, exact - kExact);
      EXPECT_LE(r.distance, exact * (1.0 + tolerance + kField) + kAbsolute) << tolerance;
      EXPECT_LE(r.distance - r.bound, exact);
      largest = std::max(largest, r.distance / exact - 1.0);
    }
  }
  EXPECT_GT(largest, 0.002) << "the largest tolerance had no effect";
  PairState state;
  for (const double invalid : {-0.001, 0.2, std::nan("")})
    EXPECT_NE(errorOf([&] {
                queryPair(ball, at(1, 0, 0), box, Pose::Identity(), {.far_tolerance = invalid}, state);
              }).find("tolerance"),
              std::string::npos);
}

TEST(Library, RejectsInvalidArguments) {
  const Structure ball = Structure::build(Shape::sphere(0.05), kCoarse);
  Pose stretched = Pose::Identity();
  stretched.linear() *= 2.0;
  EXPECT_NE(errorOf([&] { queryPair(ball, stretched, ball, at(1, 0, 0)); }).find("pose"), std::string::npos);
  EXPECT_NE(errorOf([&] { queryPair(ball, at(NAN, 0, 0), ball, at(1, 0, 0)); }).find("pose"),
            std::string::npos);
  EXPECT_NE(
      errorOf([&] { queryPair(ball, at(0, 0, 0), ball, at(1, 0, 0), {.margin = -1.0}); }).find("margin"),
      std::string::npos);
  EXPECT_NE(errorOf([&] { Shape::sphere(-1.0); }), "nothing");
  EXPECT_NE(errorOf([&] {
              Structure::build(Mesh{{Vector3d::Zero()}, {{0, 0, 7}}, {}});
            }).find("index 7"),
            std::string::npos);
  EXPECT_NE(errorOf([&] { Structure::build(Mesh{}); }), "nothing");
  const std::vector<Pose> two(2, Pose::Identity()), three(3, Pose::Identity());
  EXPECT_NE(errorOf([&] { queryPoses(ball, two, ball, three); }).find("poses"), std::string::npos);
  EXPECT_NE(errorOf([&] { queryPoses(ball, two, ball, std::span<const Pose>{}); }).find("poses"),
            std::string::npos);
  const std::vector<Pose> one(1, Pose::Identity());
  EXPECT_TRUE(queryPoses(ball, one, ball, std::span<const Pose>{}).empty());
}

TEST(Library, LoadsMechanism) {
  const Mechanism arm = Mechanism::load(testing::projectFile("data/robots/arm6/arm6.urdf"));
  ASSERT_EQ(arm.dof(), 6);
  const std::vector<double> q{0.1, 0.2, 0.3, 0.4, 0.5, 0.6};
  const std::size_t last = arm.frames() - 1;
  const Eigen::Matrix<double, 6, Eigen::Dynamic> J = arm.jacobian(q, last);
  // The Jacobian is the slope of the poses.
  constexpr double kStep = 1e-6;
  for (int i = 0; i < 6; ++i) {
    std::vector<double> up = q, down = q;
    up[static_cast<std::size_t>(i)] += kStep;
    down[static_cast<std::size_t>(i)] -= kStep;
    const Vector3d slope =
        (arm.forward(up)[last].translation() - arm.forward(down)[last].translation()) / (2 * kStep);
    EXPECT_NEAR((slope - J.col(i).head<3>()).norm(), 0.0, 1e-8);
    EXPECT_LT(arm.limits(i).lower, arm.limits(i).upper);
    EXPECT_FALSE(arm.jointName(i).empty());
  }
  EXPECT_EQ(arm.frame(arm.frameName(last)), static_cast<int>(last));
  ASSERT_FALSE(arm.bodies().empty());
  for (const LinkBody& body : arm.bodies())
    if (!body.shape) {
      EXPECT_TRUE(std::filesystem::exists(body.mesh)) << body.mesh_name;
    }
  EXPECT_THROW(arm.forward(std::vector<double>(5)), std::runtime_error);
  EXPECT_THROW(arm.limits(6), std::runtime_error);
}

TEST(Library, ReportsVersionAndDataDirectory) {
  EXPECT_NE(std::string(version()).find('.'), std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(dataDirectory() / "robots"));
}

}  // namespace library_test
}  // namespace abstand
