// Small meshes that are difficult for a sampling engine.
#include "core/verify/adversarial_bodies.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.hpp"
#include "core/verify/meshes.hpp"

namespace abstand::verify {
namespace {

// A few layers suffice: beyond them the far field is used, which is to be tested too.
constexpr int kFewOuterLayers = 6;

Vector3d normalOf(const geometry::TriangleMesh& mesh, std::size_t t) {
  return (mesh.corner(t, 1) - mesh.corner(t, 0)).cross(mesh.corner(t, 2) - mesh.corner(t, 0)).normalized();
}

/// Mean normal of the triangles that contain all of the given vertices; that of triangle t if they cancel.
Vector3d meanNormal(const geometry::TriangleMesh& mesh, std::size_t t,
                    std::initializer_list<std::uint32_t> vertices) {
  Vector3d sum = Vector3d::Zero();
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& corners = mesh.triangles[i];
    const auto holds = [&](std::uint32_t v) { return std::ranges::find(corners, v) != corners.end(); };
    if (std::ranges::all_of(vertices, holds)) sum += normalOf(mesh, i);
  }
  return sum.norm() > 1e-6 ? Vector3d(sum.normalized()) : normalOf(mesh, t);
}

/// The unit vector perpendicular to `out` in the direction of `along`.
Vector3d across(const Vector3d& out, const Vector3d& along) {
  return (along - out * out.dot(along)).normalized();
}

geometry::TriangleMesh nestedShells() {
  const geometry::TriangleMesh shell =
      together(boxMesh({0.1, 0.1, 0.1}), inverted(boxMesh({0.08, 0.08, 0.08})));
  return together(shell, boxMesh({0.02, 0.02, 0.02}, {0.01, 0.005, 0}));
}

geometry::TriangleMesh comb() {
  std::vector<std::pair<double, double>> outline{{-0.06, -0.03}, {0.06, -0.03}};
  for (int tooth = 5; tooth >= 0; --tooth) {
    const double left = -0.06 + 0.02 * tooth;
    for (const auto& [x, y] : {std::pair(0.02, 0.0), {0.013, 0.03}, {0.012, 0.03}, {0.002, 0.0}})
      outline.emplace_back(left + x, y);
  }
  outline.emplace_back(-0.06, 0.0);
  return prismMesh(outline, 0.01);
}

geometry::TriangleMesh drum(int sides) {
  std::vector<std::pair<double, double>> outline;
  for (int i = 0; i < sides; ++i)
    outline.emplace_back(0.03 * std::cos(2 * kPi * i / sides), 0.03 * std::sin(2 * kPi * i / sides));
  return prismMesh(outline, 0.05);
}

}  // namespace

Feature AdversarialBody::face(std::size_t triangle, double u, double v) const {
  if (u + v > 1.0) {
    u = 1.0 - u;
    v = 1.0 - v;
  }
  const Vector3d &a = mesh.corner(triangle, 0), &b = mesh.corner(triangle, 1), &c = mesh.corner(triangle, 2);
  const Vector3d out = normalOf(mesh, triangle);
  return {a + u * (b - a) + v * (c - a), out, across(out, b - a)};
}

Feature AdversarialBody::edge(std::size_t triangle, int corner, double part) const {
  const auto& t = mesh.triangles[triangle];
  const std::uint32_t i = t[corner], j = t[(corner + 1) % 3];
  const Vector3d edge = mesh.vertices[j] - mesh.vertices[i], out = meanNormal(mesh, triangle, {i, j});
  return {mesh.vertices[i] + part * edge, out, across(out, edge)};
}

Feature AdversarialBody::corner(std::size_t triangle, int corner) const {
  const auto& t = mesh.triangles[triangle];
  const Vector3d out = meanNormal(mesh, triangle, {t[corner]});
  const Vector3d some = std::abs(out.x()) < 0.9 ? Vector3d::UnitX() : Vector3d::UnitY();
  return {mesh.vertices[t[corner]], out, across(out, some)};
}

std::vector<AdversarialBody> adversarialBodies(int threads) {
  std::vector<AdversarialBody> bodies;
  const auto add = [&](const char* name, geometry::TriangleMesh mesh, double voxel, double point) {
    AdversarialBody body;
    body.name = name;
    body.mesh = std::move(mesh);
    body.options = {.voxel_size = voxel, .point_spacing = point, .outer_layers = kFewOuterLayers};
    bodies.push_back(std::move(body));
  };
  add("cube", boxMesh({0.1, 0.1, 0.1}), 0.005, 0.005);
  add("plate of 0.2 mm", boxMesh({0.1, 0.08, 0.0002}), 0.005, 0.005);
  add("spike", spikeMesh(0.02, 0.15), 0.005, 0.005);
  add("star", starMesh(0.03, 0.08), 0.005, 0.008);
  add("L", prismMesh({{0, 0}, {0.1, 0}, {0.1, 0.03}, {0.03, 0.03}, {0.03, 0.12}, {0, 0.12}}, 0.04), 0.005,
      0.005);
  add("nested shells", nestedShells(), 0.005, 0.005);
  add("needle of 0.4 mm", boxMesh({0.0004, 0.0004, 0.15}), 0.004, 0.002);
  add("ring", torusMesh(0.06, 0.015, 12, 8), 0.005, 0.005);
  add("comb", comb(), 0.004, 0.006);
  add("wedge", prismMesh({{0, 0}, {0.12, -0.002}, {0.12, 0.002}}, 0.06), 0.005, 0.005);
  add("drum of slivers", drum(48), 0.004, 0.004);
  add("two pieces",
      together(boxMesh({0.03, 0.03, 0.03}, {-0.08, 0, 0}), boxMesh({0.03, 0.03, 0.03}, {0.08, 0, 0})), 0.005,
      0.005);
  add("open sheet", foldedSheet(0.1), 0.005, 0.005);
  add("cube of 1 mm", boxMesh({0.001, 0.001, 0.001}), 5e-5, 2e-5);
  add("star of 1 mm", starMesh(0.0002, 0.0005), 2e-5, 2e-5);
  add("slab of 5 m", boxMesh({5.0, 3.0, 0.1}), 0.08, 0.05);
  add("ring of 5 m", torusMesh(2.0, 0.5, 12, 8), 0.1, 0.08);

  parallelFor(threads, bodies.size(), [&](std::size_t i) {
    AdversarialBody& body = bodies[i];
    body.soup = TriangleSoup(body.mesh);
    const std::shared_ptr<const geometry::Surface> surface = geometry::makeSurface(body.mesh);
    body.closed = surface->watertight();
    for (std::size_t f = 0; f < kFields.size(); ++f) {
      body.options.field = kFields[f];
      body.structures[f] = structure::buildHapticStructure(body.name, surface, body.options, 1);
    }
    body.radius = body.structures[0]->bounding_sphere.radius;
    body.centre = body.structures[0]->bounding_sphere.centre;
  });
  return bodies;
}

}  // namespace abstand::verify
