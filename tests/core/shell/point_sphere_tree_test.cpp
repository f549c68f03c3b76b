// Minimal enclosing spheres and the point-sphere tree.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/shell/point_sphere_tree.hpp"
#include "tests/core/shell/half_space.hpp"
#include "tests/support/random_pose.hpp"

namespace abstand::shell {
namespace point_sphere_tree_test {

Vector3d randomPoint(std::uint64_t seed, std::uint64_t i) {
  return {testing::randomUnit(seed, 3 * i), testing::randomUnit(seed, 3 * i + 1),
          testing::randomUnit(seed, 3 * i + 2)};
}

/// Radius by ternary search over the three coordinates of the centre: the largest distance is convex in it.
double radiusBySearch(const std::vector<Vector3d>& points, Vector3d centre, int axis = 0) {
  if (axis == 3) {
    double largest = 0.0;
    for (const Vector3d& p : points) largest = std::max(largest, (p - centre).norm());
    return largest;
  }
  double low = -1.0, high = 2.0;
  for (int i = 0; i < 40; ++i) {
    const double a = low + (high - low) / 3.0, b = high - (high - low) / 3.0;
    centre[axis] = a;
    const double fa = radiusBySearch(points, centre, axis + 1);
    centre[axis] = b;
    const double fb = radiusBySearch(points, centre, axis + 1);
    (fa < fb ? high : low) = fa < fb ? b : a;
  }
  centre[axis] = 0.5 * (low + high);
  return radiusBySearch(points, centre, axis + 1);
}

void expectContains(const geometry::EnclosingSphere& sphere, const std::vector<Vector3d>& points) {
  for (const Vector3d& p : points) ASSERT_LE((p - sphere.centre).norm(), sphere.radius);
}

TEST(MinimalSphere, MatchesClosedForms) {
  struct Case {
    const char* name;
    std::vector<Vector3d> points;
    Vector3d centre;
    double radius;
  };
  const std::vector<Case> cases = {
      {"one point", {{1, 2, 3}}, {1, 2, 3}, 0.0},
      {"twice the same", {{1, 2, 3}, {1, 2, 3}}, {1, 2, 3}, 0.0},
      {"two points", {{0, 0, 0}, {2, 0, 0}}, {1, 0, 0}, 1.0},
      {"on a line", {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}}, {1.5, 1.5, 1.5}, 1.5 * std::sqrt(3.0)},
      {"obtuse triangle", {{0, 0, 0}, {4, 0, 0}, {1, 0.5, 0}}, {2, 0, 0}, 2.0},
      {"square", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {0.5, 0.5, 0}, std::sqrt(0.5)},
      {"regular tetrahedron", {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}, {0, 0, 0}, std::sqrt(3.0)},
      {"cube and middle",
       {{0, 0, 0},
        {1, 0, 0},
        {0, 1, 0},
        {1, 1, 0},
        {0, 0, 1},
        {1, 0, 1},
        {0, 1, 1},
        {1, 1, 1},
        {0.5, 0.5, 0.5}},
       {0.5, 0.5, 0.5},
       std::sqrt(0.75)}};
  for (const Case& c : cases) {
    SCOPED_TRACE(c.name);
    const geometry::EnclosingSphere sphere = geometry::minimalSphere(c.points);
    EXPECT_NEAR(sphere.radius, c.radius, 1e-12);
    EXPECT_LE((sphere.centre - c.centre).norm(), 1e-7);
    expectContains(sphere, c.points);
  }
  EXPECT_EQ(geometry::minimalSphere({}).radius, 0.0);
}

TEST(MinimalSphere, IsMinimalForSmallRandomSets) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    std::vector<Vector3d> points;
    for (std::uint64_t i = 0; i < 2 + seed; ++i) points.push_back(randomPoint(seed, i));
    const geometry::EnclosingSphere sphere = geometry::minimalSphere(points);
    expectContains(sphere, points);
    // The search stops at about 3 (2/3)^40 = 3e-7 in each coordinate.
    EXPECT_NEAR(sphere.radius, radiusBySearch(points, Vector3d::Zero()), 1e-6);
  }
}

TEST(MinimalSphere, HandlesCosphericalAndFlatSets) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    std::vector<Vector3d> sphere_points, plane_points;
    for (std::uint64_t i = 0; i < 50; ++i) {
      const Vector3d p = randomPoint(seed, i) - Vector3d::Constant(0.5);
      sphere_points.push_back(Vector3d(10.0, 20.0, 30.0) + 0.05 * p.normalized());
      plane_points.push_back(Vector3d(p.x(), p.y(), 0.3 * p.x() - 0.2 * p.y()));
    }
    const geometry::EnclosingSphere ball = geometry::minimalSphere(sphere_points);
    expectContains(ball, sphere_points);
    EXPECT_LE(ball.radius, 0.05 * (1.0 + 1e-9));
    const geometry::EnclosingSphere disc = geometry::minimalSphere(plane_points);
    expectContains(disc, plane_points);
    // The centre of a flat set's sphere lies in its plane.
    EXPECT_NEAR(disc.centre.z(), 0.3 * disc.centre.x() - 0.2 * disc.centre.y(), 1e-9);
  }
}

class PointSphereTreeSpacing : public ::testing::TestWithParam<double> {};

TEST_P(PointSphereTreeSpacing, ContainsEveryPointOnceInsideSpheres) {
  const Pointshell shell =
      makePointshell(*geometry::makeSurface(geometry::Cuboid{{0.2, 0.1, 0.05}}), GetParam());
  const PointSphereTree tree = makeTree(shell);
  ASSERT_FALSE(tree.nodes.empty());
  ASSERT_EQ(tree.x.size() % PointSphereTree::kLane, 0u);
  ASSERT_EQ(tree.x.size(), tree.shell_index.size());

  std::vector<int> seen(shell.size(), 0);
  std::vector<int> parents(tree.nodes.size(), 0);
  std::vector<int> depth(tree.nodes.size(), 1);
  std::size_t points = 0, next_child = 1;
  for (std::size_t n = 0; n < tree.nodes.size(); ++n) {
    const PointSphereTree::Node& node = tree.nodes[n];
    if (node.children > 0) {
      ASSERT_EQ(node.points, 0);
      ASSERT_LE(node.children, PointSphereTree::kFanout);
      ASSERT_GE(node.children, 2);
      ASSERT_EQ(node.first_child, next_child) << "breadth-first";
      next_child += node.children;
      for (std::size_t c = 0; c < node.children; ++c) {
        ++parents[node.first_child + c];
        depth[node.first_child + c] = depth[n] + 1;
      }
      continue;
    }
    ASSERT_GE(node.points, 1);
    ASSERT_LE(node.points, PointSphereTree::kLeafPoints);
    ASSERT_EQ(node.first_point % PointSphereTree::kLane, 0u);
    const std::size_t padded =
        (node.points + PointSphereTree::kLane - 1u) / PointSphereTree::kLane * PointSphereTree::kLane;
    for (std::size_t k = 0; k < padded; ++k) {
      const std::size_t i = node.first_point + k;
      const std::uint32_t s = tree.shell_index[i];
      ASSERT_EQ(Vector3d(tree.x[i], tree.y[i], tree.z[i]), shell.point(s));
      ASSERT_EQ(Vector3d(tree.nx[i], tree.ny[i], tree.nz[i]), shell.normal(s));
      ASSERT_EQ(tree.area[i], k < node.points ? shell.area[s] : 0.0f);
      if (k < node.points) ++seen[s];
      if (k >= node.points) {
        ASSERT_EQ(s, tree.shell_index[node.first_point + node.points - 1u]);
      }
    }
    points += padded;
  }
  EXPECT_EQ(points, tree.x.size());
  EXPECT_TRUE(std::all_of(seen.begin(), seen.end(), [](int count) { return count == 1; }));
  EXPECT_EQ(parents[0], 0);
  EXPECT_TRUE(std::all_of(parents.begin() + 1, parents.end(), [](int count) { return count == 1; }));
  EXPECT_EQ(*std::max_element(depth.begin(), depth.end()), tree.levels);

  // Every ancestor's sphere holds the points of its leaves, and hardly more than they need.
  std::vector<std::vector<Vector3d>> below(tree.nodes.size());
  for (std::size_t n = tree.nodes.size(); n-- > 0;) {
    const PointSphereTree::Node& node = tree.nodes[n];
    for (std::size_t k = 0; k < node.points; ++k) {
      const std::size_t i = node.first_point + k;
      below[n].emplace_back(tree.x[i], tree.y[i], tree.z[i]);
    }
    for (std::size_t c = 0; c < node.children; ++c) {
      const auto& child = below[node.first_child + c];
      below[n].insert(below[n].end(), child.begin(), child.end());
    }
    const Vector3d centre(node.cx, node.cy, node.cz);
    for (const Vector3d& p : below[n]) ASSERT_LE((p - centre).norm(), node.radius);
    // The centre is rounded to float.
    ASSERT_LE(node.radius, geometry::minimalSphere(below[n]).radius + 1e-7);
  }
  // Full leaves: one subtree may end in a leaf that is not.
  EXPECT_LE(tree.x.size(), shell.size() + PointSphereTree::kLane);
}

INSTANTIATE_TEST_SUITE_P(Spacings, PointSphereTreeSpacing, ::testing::Values(0.002, 0.005, 0.01, 0.03, 0.2));

TEST(PointSphereTree, HandlesSmallShells) {
  EXPECT_TRUE(makeTree(Pointshell{}).nodes.empty());
  for (std::size_t count : {1u, 8u, 16u, 17u, 128u, 129u, 1025u}) {
    Pointshell shell;
    for (std::size_t i = 0; i < count; ++i) {
      const Vector3d p = randomPoint(7, i);
      for (auto* v : {&shell.nx, &shell.ny, &shell.nz, &shell.area}) v->push_back(1.0f);
      shell.x.push_back(float(p.x())), shell.y.push_back(float(p.y())), shell.z.push_back(float(p.z()));
    }
    const PointSphereTree tree = makeTree(shell);
    EXPECT_EQ(tree.levels, count <= 8 ? 1 : count <= 64 ? 2 : count <= 512 ? 3 : 4) << count;
    EXPECT_EQ(tree.x.size(), (count + 7) / 8 * 8) << count;
  }
}

TEST(PointSphereTree, LeavesAreCompact) {
  const Pointshell shell = makePointshell(*geometry::makeSurface(geometry::Sphere{0.1}), 0.005);
  const PointSphereTree tree = makeTree(shell);
  double sum = 0.0;
  int leaves = 0;
  for (const PointSphereTree::Node& node : tree.nodes) {
    if (node.children == 0) sum += node.radius, ++leaves;
  }
  // Sixteen points of 29 mm^2 fill a square whose circumscribed circle has a radius of 15.2 mm.
  EXPECT_LE(sum / leaves, 0.0152);
}

}  // namespace point_sphere_tree_test
}  // namespace abstand::shell
