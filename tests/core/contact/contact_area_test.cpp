// Contact patches of shapes and meshes: closed forms, one-sidedness, undercuts, neighbours, round persons.
#include "core/contact/contact_area.hpp"

#include <gtest/gtest.h>

#include "core/contact/contact_patch.hpp"
#include "core/contact/contact_shadow.hpp"

#include "tests/support/brute_force.hpp"
#include "tests/support/bumpy_meshes.hpp"
#include "tests/support/random_pose.hpp"
#include "tests/support/structures.hpp"

namespace abstand::contact {
namespace contact_area_test {

using testing::randomPose;

constexpr double kExact = 1e-9;  // relative: sums of exact cuts
// Triangles lie up to a sagitta within the shape, and the indentation is shortened by another: 0.1 mm of the
// 4 mm here. An area grows with the depth at most, a volume with its square.
constexpr double kTessellated = 0.025, kTessellatedVolume = 0.05;
constexpr double kX = 0.004;  // m

ContactArea areaOf(const geometry::Shape& shape, const Vector3d& p, const Vector3d& n, double x = kX,
                   double body_radius = kInfinity) {
  const ContactSurface surface(*geometry::makeSurface(shape));
  return contactArea(surface, {p, n.normalized(), x, body_radius});
}

/// Between (1 - share) of the exact value and the value: never above.
void expectBelow(double value, double exact, double share) {
  EXPECT_LE(value, exact * (1.0 + kExact));
  EXPECT_GE(value, exact * (1.0 - share));
}

geometry::TriangleMesh cuboidMesh(const Vector3d& size, const Vector3d& centre) {
  geometry::TriangleMesh mesh = geometry::tessellate(geometry::Cuboid{size}, 0.01);
  for (Vector3d& v : mesh.vertices) v += centre;
  return mesh;
}

void append(geometry::TriangleMesh& mesh, const geometry::TriangleMesh& more) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), more.vertices.begin(), more.vertices.end());
  for (const auto& t : more.triangles) mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
}

/// A polygon of the xz plane, counter-clockwise seen from -y, drawn out along y by `length` about 0. The
/// polygon is cut into `faces`, convex and of its corners alone.
geometry::TriangleMesh extruded(const std::vector<Eigen::Vector2d>& outline,
                                const std::vector<std::vector<std::uint32_t>>& faces, double length) {
  geometry::TriangleMesh mesh;
  const auto n = static_cast<std::uint32_t>(outline.size());
  for (const double y : {-0.5 * length, 0.5 * length})
    for (const Eigen::Vector2d& c : outline) mesh.vertices.emplace_back(c.x(), y, c.y());
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    mesh.triangles.push_back({i, i + n, j});
    mesh.triangles.push_back({j, i + n, j + n});
  }
  for (const auto& face : faces)
    for (std::size_t i = 1; i + 1 < face.size(); ++i) {
      mesh.triangles.push_back({face[0], face[i], face[i + 1]});
      mesh.triangles.push_back({face[0] + n, face[i + 1] + n, face[i] + n});
    }
  return mesh;
}

TEST(ContactArea, BallMatchesSphericalCap) {
  for (const double r : {0.02, 0.05, 0.15}) {
    const ContactArea a = areaOf(geometry::Sphere{r}, {0, 0, r}, {0, 0, 1});
    expectBelow(a.area, M_PI * (2.0 * r * kX - kX * kX), kTessellated);
    expectBelow(a.volume, M_PI * kX * kX * (r - kX / 3.0), kTessellatedVolume);
    EXPECT_TRUE(a.certified);
    // p_max = 2 F / A for a shallow cap, and never below.
    const double exact = 100.0 * kX / (M_PI * kX * kX * (r - kX / 3.0));
    EXPECT_GE(a.peakPressure(100.0), exact);
    EXPECT_LE(a.peakPressure(100.0), exact / (1.0 - kTessellatedVolume));
  }
}

TEST(ContactArea, CylinderSideMatchesLengthTimesChord) {
  const double r = 0.05, length = 0.3;
  const ContactArea a = areaOf(geometry::Cylinder{r, length}, {r, 0, 0}, {1, 0, 0});
  const double half = std::sqrt(2.0 * r * kX - kX * kX), angle = std::acos(1.0 - kX / r);
  expectBelow(a.area, length * 2.0 * half, kTessellated);
  expectBelow(a.volume, length * (r * r * angle - (r - kX) * half), kTessellatedVolume);
}

TEST(ContactArea, FlatFaceIsWholeFace) {
  const ContactArea a = areaOf(geometry::Cuboid{{0.1, 0.06, 0.2}}, {0.01, 0.02, 0.1}, {0, 0, 1});
  EXPECT_NEAR(a.area, 0.006, kExact * 0.006);
  EXPECT_NEAR(a.volume, 0.006 * kX, kExact * 0.006 * kX);
  EXPECT_NEAR(a.peakPressure(60.0), 1e4, 1e-5);
  EXPECT_EQ(a.offset, 0.0);
}

TEST(ContactArea, EdgeAndCornerMatchClosedForm) {
  const double length = 0.06;
  const geometry::Shape box = geometry::Cuboid{{0.1, length, 0.2}};
  const ContactArea edge = areaOf(box, {0.05, 0.01, 0.1}, {1, 0, 1});
  EXPECT_NEAR(edge.area, length * 2.0 * kX, kExact * edge.area);
  EXPECT_NEAR(edge.volume, length * kX * kX, kExact * edge.volume);
  EXPECT_NEAR(edge.peakPressure(100.0), 2.0 * edge.meanPressure(100.0), kExact * edge.peakPressure(100.0));
  // The plane cuts an equilateral triangle off the corner: 3 sqrt(3) / 2 x^2, and a third of its depth.
  const ContactArea corner = areaOf(box, {0.05, 0.03, 0.1}, {1, 1, 1});
  EXPECT_NEAR(corner.area, 1.5 * std::sqrt(3.0) * kX * kX, kExact * corner.area);
  EXPECT_NEAR(corner.volume, corner.area * kX / 3.0, kExact * corner.volume);
  EXPECT_GT(corner.peakPressure(100.0), 10.0 * edge.peakPressure(100.0));
}

TEST(ContactArea, IsIndependentOfPointSpacing) {
  // A blade of 0.2 mm, far below any pointshell's spacing: its end face is exact.
  const ContactArea a = areaOf(geometry::Cuboid{{2e-4, 0.05, 0.1}}, {0, 0, 0.05}, {0, 0, 1}, 1e-5);
  EXPECT_NEAR(a.area, 1e-5, kExact * 1e-5);
}

TEST(ContactArea, GrowsWithIndentationAndIsRotationInvariant) {
  const geometry::TriangleMesh mesh = testing::bumpyBall(0.1, 1e-3);
  const ContactSurface surface(*geometry::makeSurface(mesh));
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    const Transform X = randomPose(seed);
    geometry::TriangleMesh turned = mesh;
    for (Vector3d& v : turned.vertices) v = X * v;
    const ContactSurface other(*geometry::makeSurface(turned));
    const Vector3d n = randomPose(seed + 100).linear().col(0);
    const auto foremost = std::max_element(mesh.vertices.begin(), mesh.vertices.end(),
                                           [&](const auto& a, const auto& b) { return n.dot(a) < n.dot(b); });
    double last_area = 0.0, last_volume = 0.0;
    for (const double x : {0.001, 0.003, 0.01, 0.03}) {
      const ContactArea a = contactArea(surface, {*foremost, n, x});
      const ContactArea b = contactArea(other, {X * *foremost, X.linear() * n, x});
      EXPECT_NEAR(a.area, b.area, 1e-9 * a.area);
      EXPECT_NEAR(a.volume, b.volume, 1e-9 * a.volume);
      EXPECT_GT(a.area, last_area);
      EXPECT_GT(a.volume, last_volume);
      last_area = a.area, last_volume = a.volume;
    }
  }
}

TEST(ContactArea, BumpyBallMatchesRayCasting) {
  // Columns along the approach, and the first triangle that each meets, by brute force. They see other hills
  // within the indentation too; on this ball and at this depth there is one patch.
  const geometry::TriangleMesh mesh = testing::bumpyBall(0.1, 1e-3);
  const ContactSurface surface(*geometry::makeSurface(mesh));
  const double x = 0.03, pitch = 1e-3;
  const auto top = std::max_element(mesh.vertices.begin(), mesh.vertices.end(),
                                    [](const auto& a, const auto& b) { return a.z() < b.z(); });
  const ContactArea a = contactArea(surface, {*top, Vector3d::UnitZ(), x});
  double area = 0.0, volume = 0.0;
  for (double u = -0.15; u < 0.15; u += pitch)
    for (double v = -0.15; v < 0.15; v += pitch) {
      double height = -kInfinity;
      for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const Vector3d &p = mesh.corner(t, 0), &q = mesh.corner(t, 1), &r = mesh.corner(t, 2);
        const Eigen::Matrix2d edges = (Eigen::Matrix2d() << (q - p).head<2>(), (r - p).head<2>()).finished();
        if (std::abs(edges.determinant()) < 1e-15) continue;
        const Eigen::Vector2d w = edges.inverse() * (Eigen::Vector2d(u, v) - p.head<2>());
        if (w.x() < 0.0 || w.y() < 0.0 || w.sum() > 1.0) continue;
        height = std::max(height, p.z() + w.x() * (q - p).z() + w.y() * (r - p).z());
      }
      const double depth = height - top->z() + x;
      if (depth > 0.0) area += pitch * pitch, volume += depth * pitch * pitch;
    }
  // Half a pitch along the patch's rim of some 0.4 m, at random sides, and its square root.
  EXPECT_NEAR(a.area, area, 0.01 * area);
  EXPECT_NEAR(a.volume, volume, 0.01 * volume);
}

TEST(ContactArea, MatchesDensePointshell) {
  // A point stands for an area a; seen along the approach it is a times the cosine of its normal, which
  // points inwards. Some 900 points in the cap; those at its rim count whole or not at all.
  const geometry::Shape ball = geometry::Sphere{0.1};
  const auto& shell = testing::structureOf(ball, structure::FieldKind::kMixed).shell;
  const double x = 0.04;
  double area = 0.0, volume = 0.0;
  for (std::size_t i = 0; i < shell.size(); ++i) {
    const double depth = shell.point(i).z() - 0.1 + x, projected = -shell.normal(i).z() * shell.area[i];
    if (depth > 0.0) area += projected, volume += projected * depth;
  }
  const ContactArea exact = areaOf(ball, {0, 0, 0.1}, {0, 0, 1}, x);
  EXPECT_NEAR(exact.area, area, 0.02 * area);
  EXPECT_NEAR(exact.volume, volume, 0.02 * volume);
}

TEST(ContactArea, CountsHiddenSurfaceOnce) {
  // An I-beam of 0.1 m on its side: flanges 40 and 60 mm wide, the web 10 mm; all of it is pressed in.
  const std::vector<Eigen::Vector2d> outline = {
      {-0.03, 0.0}, {0.03, 0.0},   {0.03, 0.005},  {0.005, 0.005},  {0.005, 0.015},  {0.02, 0.015},
      {0.02, 0.02}, {-0.02, 0.02}, {-0.02, 0.015}, {-0.005, 0.015}, {-0.005, 0.005}, {-0.03, 0.005}};
  const geometry::TriangleMesh beam =
      extruded(outline, {{0, 1, 2, 3, 10, 11}, {3, 4, 9, 10}, {6, 7, 8, 9, 4, 5}}, 0.1);
  const auto body = geometry::makeSurface(beam);
  ASSERT_TRUE(body->watertight());
  ASSERT_GT(body->massProperties().volume, 0.0);
  const ContactSurface surface(*body);
  const auto at = [&](double x) { return contactArea(surface, {{0, 0, 0.02}, {0, 0, 1}, x}).area; };
  EXPECT_NEAR(at(0.004), 0.004, 1e-9);
  EXPECT_NEAR(at(0.010), 0.004, 1e-9);  // through the upper flange, into the web
  EXPECT_NEAR(at(0.018), 0.006, 1e-9);  // the lower flange, where the upper one does not hide it
}

/// The extent with every triangle of the mesh asked whether it hides the patch.
PatchExtent extentBesideAllTriangles(const ContactSurface& surface, const ContactPlace& place) {
  ContactPatch patch = contactPatch(surface, place, place.indentation);
  patch.back.clear();
  const Vector3d u = place.n_B.unitOrthogonal(), v = place.n_B.cross(u);
  Matrix3d R_PB;
  R_PB << u.transpose(), v.transpose(), place.n_B.transpose();
  const double level = (R_PB * (patch.foremost_B - place.p_B)).z() - place.indentation;
  for (const auto& triangle : surface.mesh().triangles) {
    PatchPolygon polygon;
    double top = -kInfinity;
    for (const std::uint32_t c : triangle) {
      polygon.add(R_PB * (surface.mesh().vertices[c] - place.p_B));
      top = std::max(top, polygon.corners[static_cast<std::size_t>(polygon.count - 1)].z());
    }
    if (top >= level && polygon.area() < 0.0) patch.back.push_back(polygon);
  }
  return visibleExtent(patch);
}

TEST(ContactArea, IsBitIdenticalToExhaustiveSearch) {
  const ContactSurface torus(*geometry::makeSurface(testing::bumpyTorus(0.1, 0.04, 120, 40))),
      ball(*geometry::makeSurface(testing::bumpyBall(0.1, 1e-3)));
  bool hidden = false;
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    SCOPED_TRACE(seed);
    // Turns between the surfaces, as the memory of a search is kept for the next one.
    const ContactSurface& surface = seed % 2 == 0 ? torus : ball;
    const Transform X = randomPose(seed, 0.15);
    ContactPlace place{surface.nearest(X.translation()).point, X.linear().col(2), 0.0, kInfinity};
    place.indentation = seed % 3 == 0 ? 0.03 : kX;
    if (seed % 5 < 3) place.body_radius = 0.04;
    const PatchExtent all = extentBesideAllTriangles(surface, place);
    const ContactArea found = contactArea(surface, place);
    EXPECT_EQ(found.area, all.area);
    EXPECT_EQ(found.volume, all.volume);
    EXPECT_EQ(found.triangles, all.pieces);
    ContactPatch alone = contactPatch(surface, place, place.indentation);
    alone.back.clear();
    hidden = hidden || visibleExtent(alone).area > found.area;
  }
  EXPECT_TRUE(hidden) << "some patch lies partly behind other surface";
}

TEST(ContactArea, ThinPlateIsItsFaceAtAnyDepth) {
  const geometry::Shape plate = geometry::Cuboid{{0.1, 0.1, 0.002}};
  const ContactArea a = areaOf(plate, {0.0, 0.0, 0.001}, {0, 0, 1}, 0.02);
  EXPECT_NEAR(a.area, 0.01, kExact);
  // And of a ball that is pressed in beyond its equator its shadow, by what its triangles leave.
  const double r = 0.01;
  expectBelow(areaOf(geometry::Sphere{r}, {0, 0, r}, {0, 0, 1}, 0.025).area, M_PI * r * r, kTessellated);
}

TEST(ContactArea, ExcludesNeighbouringPatches) {
  // Two fingers on a palm: pressed by less than their length, only the one that is touched counts.
  geometry::TriangleMesh fingers = cuboidMesh({0.01, 0.01, 0.05}, {0, 0, 0});
  append(fingers, cuboidMesh({0.01, 0.01, 0.05}, {0.03, 0, 0}));
  const ContactSurface surface(*geometry::makeSurface(fingers));
  EXPECT_NEAR(contactArea(surface, {{0.001, 0, 0.025}, {0, 0, 1}, kX}).area, 1e-4, kExact);
  EXPECT_NEAR(contactArea(surface, {{0.029, 0, 0.025}, {0, 0, 1}, kX}).area, 1e-4, kExact);
}

TEST(ContactArea, FindsForemostPointBeyondContactPoint) {
  // The normal points past the contact point: the patch is that of the edge, and the offset says so.
  const Vector3d n = Vector3d(std::sin(0.1), 0, std::cos(0.1));
  const ContactArea a = areaOf(geometry::Cuboid{{0.1, 0.06, 0.2}}, {0, 0, 0.1}, n);
  EXPECT_NEAR(a.offset, 0.05 * std::sin(0.1), 1e-12);
  EXPECT_NEAR(a.foremost_B.x(), 0.05, 1e-12);
  EXPECT_LT(a.area, 0.06 * 0.05);
}

TEST(ContactArea, FlatFaceOnRoundBodyIsBodyCap) {
  // Depth x - rho^2 / 2R: A = 2 pi R x, V = pi R x^2, so that p_max = 2 F / A.
  for (const double radius : {0.01, 0.04, 0.1}) {
    const ContactArea a = areaOf(geometry::Cuboid{{0.4, 0.4, 0.2}}, {0.01, 0.02, 0.1}, {0, 0, 1}, kX, radius);
    expectBelow(a.area, 2.0 * M_PI * radius * kX, 0.08);
    expectBelow(a.volume, M_PI * radius * kX * kX, 0.08);
  }
  // A ball of radius r on a person of radius R is as a ball of 1 / (1/r + 1/R), as long as both are shallow.
  const double r = 0.05, radius = 0.04, both = r * radius / (r + radius), x = 0.002;
  const ContactArea a = areaOf(geometry::Sphere{r}, {0, 0, r}, {0, 0, 1}, x, radius);
  expectBelow(a.area, 2.0 * M_PI * both * x, 0.15);
  // An edge narrower than the person's cap stays an edge.
  const ContactArea blade = areaOf(geometry::Cuboid{{0.002, 0.4, 0.1}}, {0, 0, 0.05}, {0, 0, 1}, kX, 0.04);
  expectBelow(blade.area, 0.002 * 2.0 * std::sqrt(2.0 * 0.04 * kX), 0.05);
}

TEST(ContactArea, IsZeroForInvalidInput) {
  const ContactSurface ball(*geometry::makeSurface(geometry::Sphere{0.05}));
  const ContactPlace good{{0, 0, 0.05}, {0, 0, 1}, kX};
  ContactPlace bad = good;
  bad.indentation = ball.sagitta();
  EXPECT_EQ(contactArea(ball, bad).area, 0.0);
  EXPECT_EQ(contactArea(ball, bad).peakPressure(1.0), kInfinity);
  for (const double x : {0.0, -1.0, kNaN, kInfinity}) {
    bad.indentation = x;
    EXPECT_EQ(contactArea(ball, bad).area, 0.0) << x;
  }
  bad = good;
  bad.n_B = {0, 0, 2};
  EXPECT_EQ(contactArea(ball, bad).area, 0.0);
  bad = good;
  bad.p_B.x() = kNaN;
  EXPECT_EQ(contactArea(ball, bad).area, 0.0);
  bad = good;
  bad.body_radius = 0.0;
  EXPECT_EQ(contactArea(ball, bad).area, 0.0);
}

TEST(ContactArea, OpenMeshIsNotCertified) {
  geometry::TriangleMesh open = cuboidMesh({0.1, 0.1, 0.1}, {0, 0, 0});
  open.triangles.pop_back();
  const ContactSurface surface(*geometry::makeSurface(open));
  EXPECT_FALSE(contactArea(surface, {{0, 0, 0.05}, {0, 0, 1}, kX}).certified);
}

}  // namespace contact_area_test
}  // namespace abstand::contact
