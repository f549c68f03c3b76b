#include "abstand/mesh.hpp"

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
  const Vector3d& v = shape.sizes();
  switch (shape.kind()) {
    case Shape::Kind::kSphere:
      return geometry::Sphere{v.x()};
    case Shape::Kind::kEllipsoid:
      return geometry::Ellipsoid{v};
    case Shape::Kind::kCuboid:
      return geometry::Cuboid{v};
    case Shape::Kind::kCylinder:
      return geometry::Cylinder{v.x(), v.y()};
    case Shape::Kind::kCapsule:
      break;
  }
  return geometry::Capsule{v.x(), v.y()};
}

Shape shapeOf(const geometry::Shape& shape) {
  if (const auto* s = std::get_if<geometry::Sphere>(&shape)) return Shape::sphere(s->radius);
  if (const auto* s = std::get_if<geometry::Ellipsoid>(&shape)) return Shape::ellipsoid(s->semi_axes);
  if (const auto* s = std::get_if<geometry::Cuboid>(&shape)) return Shape::cuboid(s->size);
  if (const auto* s = std::get_if<geometry::Cylinder>(&shape)) return Shape::cylinder(s->radius, s->length);
  const auto& capsule = std::get<geometry::Capsule>(shape);
  return Shape::capsule(capsule.radius, capsule.length);
}

Mesh meshOf(geometry::TriangleMesh mesh) { return {std::move(mesh.vertices), std::move(mesh.triangles), {}}; }

}  // namespace abstand::facade
