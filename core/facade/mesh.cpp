#include "abstand/mesh.hpp"

#include <iterator>

#include "core/facade/structure_impl.hpp"
#include "core/mesh_file/mesh_file.hpp"

namespace abstand {

Mesh loadMesh(const std::filesystem::path& file, double scale) {
  mesh_file::LoadedMesh loaded = mesh_file::loadMesh(file, scale);
  Mesh mesh = facade::meshOf(std::move(loaded.mesh));
  mesh.remarks = std::move(loaded.report.remarks);
  return mesh;
}

Shape::Shape(Kind kind, const Vector3d& sizes) : kind_(kind), sizes_(sizes) {
  geometry::validate(facade::shapeOf(*this));
}

Shape Shape::sphere(double radius) { return {Kind::kSphere, {radius, 0.0, 0.0}}; }
Shape Shape::ellipsoid(const Vector3d& semi_axes) { return {Kind::kEllipsoid, semi_axes}; }
Shape Shape::cuboid(const Vector3d& size) { return {Kind::kCuboid, size}; }
Shape Shape::cylinder(double radius, double length) { return {Kind::kCylinder, {radius, length, 0.0}}; }
Shape Shape::capsule(double radius, double length) { return {Kind::kCapsule, {radius, length, 0.0}}; }

}  // namespace abstand

namespace abstand::facade {

geometry::Shape shapeOf(const Shape& shape) {
  return geometry::shapeOf(static_cast<std::size_t>(shape.kind()), shape.sizes()).value();
}

Shape shapeOf(const geometry::Shape& shape) {
  const Vector3d v = geometry::dimensionsOf(shape);
  using Make = Shape (*)(const Vector3d&);
  constexpr Make kMakers[] = {[](const Vector3d& d) { return Shape::sphere(d.x()); },
                              [](const Vector3d& d) { return Shape::ellipsoid(d); },
                              [](const Vector3d& d) { return Shape::cuboid(d); },
                              [](const Vector3d& d) { return Shape::cylinder(d.x(), d.y()); },
                              [](const Vector3d& d) { return Shape::capsule(d.x(), d.y()); }};
  static_assert(std::size(kMakers) == std::variant_size_v<geometry::Shape>);
  return kMakers[shape.index()](v);
}

Mesh meshOf(geometry::TriangleMesh mesh) { return {std::move(mesh.vertices), std::move(mesh.triangles), {}}; }

}  // namespace abstand::facade
