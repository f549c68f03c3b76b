#include "abstand/structure.hpp"

#include "core/base/error.hpp"
#include "core/facade/structure_impl.hpp"
#include "core/store/structure_file.hpp"

namespace abstand {
namespace {

structure::HapticOptions hapticOptions(const StructureOptions& options) {
  structure::HapticOptions o{.voxel_size = options.voxel_size,
                             .point_spacing = options.point_spacing,
                             .outer_layers = options.outer_layers};
  switch (options.field) {
    case StructureOptions::Field::kLayered:
      o.field = structure::FieldKind::kLayered;
      break;
    case StructureOptions::Field::kFloat:
      o.field = structure::FieldKind::kFloat;
      break;
    case StructureOptions::Field::kMixed:
      o.field = structure::FieldKind::kMixed;
      break;
  }
  return o;
}

store::StructureCache cacheFor(bool wanted) {
  return store::StructureCache(wanted ? store::userCacheFolder() : std::filesystem::path());
}

Structure shared(std::shared_ptr<const structure::HapticStructure> made) {
  return Structure(std::make_shared<const Structure::Impl>(Structure::Impl{std::move(made)}));
}

geometry::TriangleMesh checkedMesh(const Mesh& mesh) {
  const auto vertices = mesh.vertices.size();
  for (const auto& triangle : mesh.triangles)
    for (const std::uint32_t corner : triangle)
      if (corner >= vertices)
        throw UsageError("found the index " + std::to_string(corner) + " in a mesh, expected less than its " +
                         std::to_string(vertices) + " vertices");
  for (const Vector3d& p : mesh.vertices)
    if (!p.allFinite()) throw UsageError("found a vertex that is not finite, expected finite numbers");
  return geometry::weld({mesh.vertices, mesh.triangles}, 0.0);
}

}  // namespace

Structure Structure::build(const Mesh& mesh, const StructureOptions& options, const std::string& name) {
  store::StructureCache cache = cacheFor(options.cache);
  return shared(store::makeHapticStructure(cache, name, store::makeSurface(cache, checkedMesh(mesh)),
                                           hapticOptions(options), options.threads)
                    .structure);
}

Structure Structure::build(const Shape& shape, const StructureOptions& options, const std::string& name) {
  store::StructureCache cache = cacheFor(options.cache);
  return shared(store::makeHapticStructure(cache, name, geometry::makeSurface(facade::shapeOf(shape)),
                                           hapticOptions(options), options.threads)
                    .structure);
}

Structure Structure::load(const std::filesystem::path& file, Origin origin, int threads, bool with_cache) {
  store::StructureCache cache = cacheFor(with_cache);
  return shared(store::loadStructure(file, origin == Origin::kOwn, cache, threads));
}

void Structure::save(const std::filesystem::path& file) const { store::saveStructure(*impl_->made, file); }

const std::string& Structure::name() const { return impl_->made->name; }

StructureOptions Structure::options() const {
  const structure::HapticOptions& o = impl_->made->options;
  StructureOptions options;
  options.voxel_size = o.voxel_size;
  options.point_spacing = o.point_spacing;
  options.outer_layers = o.outer_layers;
  options.field = o.field == structure::FieldKind::kLayered ? StructureOptions::Field::kLayered
                  : o.field == structure::FieldKind::kFloat ? StructureOptions::Field::kFloat
                                                            : StructureOptions::Field::kMixed;
  return options;
}

double Structure::volume() const { return impl_->made->mass_properties.volume; }
Vector3d Structure::centreOfMass() const { return impl_->made->com; }
double Structure::radius() const {
  const geometry::EnclosingSphere& sphere = impl_->made->bounding_sphere;
  return sphere.centre.norm() + sphere.radius;
}
bool Structure::watertight() const { return impl_->made->surface->watertight(); }
double Structure::errorBound() const { return impl_->made->errorBound(); }
std::size_t Structure::points() const { return impl_->made->shell.size(); }
std::size_t Structure::surfaceVoxels() const { return impl_->made->surface_voxels; }
std::size_t Structure::memoryBytes() const { return impl_->made->memoryBytes(); }
Mesh Structure::mesh(double sagitta) const { return facade::meshOf(impl_->made->surface->mesh(sagitta)); }

}  // namespace abstand
