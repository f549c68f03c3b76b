#include "app/session/structure_library.hpp"

#include <chrono>

#include "core/base/error.hpp"
#include "core/base/number.hpp"
#include "core/base/parallel.hpp"
#include "core/geometry/mesh_file.hpp"

namespace abstand {
namespace {

std::string shapeText(const Shape& shape) {
  const auto numbers = [](auto... v) { return ((":" + formatDouble(v)) + ...); };
  return std::visit(
      [&](const auto& s) -> std::string {
        using T = std::decay_t<decltype(s)>;
        const std::string name{shapeName(s)};
        if constexpr (std::is_same_v<T, Sphere>)
          return name + numbers(s.radius);
        else if constexpr (std::is_same_v<T, Ellipsoid>)
          return name + numbers(s.semi_axes.x(), s.semi_axes.y(), s.semi_axes.z());
        else if constexpr (std::is_same_v<T, Cuboid>)
          return name + numbers(s.size.x(), s.size.y(), s.size.z());
        else
          return name + numbers(s.radius, s.length);
      },
      shape);
}

std::string optionsText(const HapticOptions& o) {
  return "|" + formatDouble(o.voxel_size) + "|" + formatDouble(o.point_spacing) + "|" +
         std::to_string(o.outer_layers) + "|" + std::string(fieldName(o.field));
}

}  // namespace

StructureLibrary::Key StructureLibrary::add(const std::string& identity, std::string name,
                                            std::shared_ptr<const Surface> surface,
                                            const HapticOptions& options) {
  options.validate();
  const auto [it, fresh] = by_identity_.try_emplace(identity + optionsText(options), entries_.size());
  if (fresh) entries_.push_back({std::move(name), std::move(surface), options, nullptr});
  return it->second;
}

StructureLibrary::Key StructureLibrary::request(const Shape& shape, const HapticOptions& options) {
  const std::string identity = shapeText(shape);
  auto& surface = surfaces_[identity];
  if (!surface) surface = makeSurface(shape);
  return add(identity, identity, surface, options);
}

StructureLibrary::Key StructureLibrary::request(const std::filesystem::path& mesh, double scale,
                                                const HapticOptions& options) {
  const std::string identity = mesh.string() + "*" + formatDouble(scale);
  auto& surface = surfaces_[identity];
  if (!surface) {
    LoadedMesh loaded = loadMesh(mesh, scale);
    for (const auto& remark : loaded.report.remarks) remarks_.push_back(mesh.string() + ": " + remark);
    surface = makeSurface(std::move(loaded.mesh));
  }
  return add(identity, mesh.stem().string(), surface, options);
}

void StructureLibrary::build(int threads) {
  const auto begin = std::chrono::steady_clock::now();
  parallelFor(threads, entries_.size(), [&](std::size_t i) {
    Entry& e = entries_[i];
    if (!e.structure) e.structure = buildHapticStructure(e.name, e.surface, e.options, 1);
  });
  build_ms_ += std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace abstand
