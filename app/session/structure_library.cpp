#include "app/session/structure_library.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>

#include "core/base/error.hpp"
#include "core/base/number.hpp"
#include "core/base/parallel.hpp"
#include "core/mesh_file/mesh_file.hpp"
#include "core/store/structure_file.hpp"

namespace abstand::session {
namespace {

std::string shapeText(const geometry::Shape& shape) {
  const auto numbers = [](auto... v) { return ((":" + formatDouble(v)) + ...); };
  return std::visit(
      [&](const auto& s) -> std::string {
        using T = std::decay_t<decltype(s)>;
        const std::string name{geometry::shapeName(s)};
        if constexpr (std::is_same_v<T, geometry::Sphere>)
          return name + numbers(s.radius);
        else if constexpr (std::is_same_v<T, geometry::Ellipsoid>)
          return name + numbers(s.semi_axes.x(), s.semi_axes.y(), s.semi_axes.z());
        else if constexpr (std::is_same_v<T, geometry::Cuboid>)
          return name + numbers(s.size.x(), s.size.y(), s.size.z());
        else
          return name + numbers(s.radius, s.length);
      },
      shape);
}

std::string optionsText(const structure::HapticOptions& o) {
  return "|" + formatDouble(o.voxel_size) + "|" + formatDouble(o.point_spacing) + "|" +
         std::to_string(o.outer_layers) + "|" + std::string(structure::fieldName(o.field));
}

mesh_file::LoadedMesh loadScaled(const std::filesystem::path& mesh, const Vector3d& scale) {
  if (scale.x() > 0.0 && scale == Vector3d::Constant(scale.x())) return mesh_file::loadMesh(mesh, scale.x());
  mesh_file::LoadedMesh loaded = mesh_file::loadMesh(mesh);
  geometry::stretch(loaded.mesh, scale);
  return loaded;
}

/// A mesh of this size may not be in metres; MeshReport::remarks has a text for these sizes.
bool oddSize(const mesh_file::MeshReport& report) {
  const double size = report.extent.maxCoeff();
  return size >= 20.0 || size < 1e-3;
}

/// Combined progress of structures that are built concurrently.
class SharedProgress {
 public:
  SharedProgress(const structure::BuildMonitor& monitor, const std::vector<double>& work)
      : monitor_(monitor), work_(work), done_(work.size(), 0.0) {
    for (const double w : work) all_ += w;
  }

  /// Monitor of structure i.
  structure::BuildMonitor part(std::size_t i, const std::string& name) {
    structure::BuildMonitor part;
    part.cancelled = monitor_.cancelled;
    if (monitor_.progress)
      part.progress = [this, i, name](double fraction, std::string_view) { tell(i, fraction, name); };
    return part;
  }

 private:
  void tell(std::size_t i, double fraction, const std::string& name) {
    const std::scoped_lock lock(mutex_);
    done_[i] = fraction * work_[i];
    double sum = 0.0;
    for (const double d : done_) sum += d;
    monitor_.progress(std::min(1.0, sum / all_), name);
  }

  const structure::BuildMonitor& monitor_;
  const std::vector<double>& work_;
  std::vector<double> done_;
  double all_{0.0};
  std::mutex mutex_;
};

}  // namespace

StructureLibrary::Key StructureLibrary::add(const std::string& identity, std::string name,
                                            std::shared_ptr<Body> body,
                                            const structure::HapticOptions& options) {
  options.validate();
  const auto [it, fresh] = by_identity_.try_emplace(identity + optionsText(options), entries_.size());
  if (fresh) entries_.push_back({std::move(name), std::move(body), options, nullptr});
  return it->second;
}

StructureLibrary::Key StructureLibrary::request(const geometry::Shape& shape,
                                                const structure::HapticOptions& options) {
  const std::string identity = shapeText(shape);
  auto& body = bodies_[identity];
  if (!body) body = std::make_shared<Body>(Body{{}, geometry::makeSurface(shape), {}});
  return add(identity, identity, body, options);
}

StructureLibrary::Key StructureLibrary::request(const std::filesystem::path& mesh, const Vector3d& scale,
                                                const structure::HapticOptions& options) {
  const std::string identity = mesh.string() + "*" + formatDouble(scale.x()) + "*" + formatDouble(scale.y()) +
                               "*" + formatDouble(scale.z());
  auto& body = bodies_[identity];
  if (!body) {
    mesh_file::LoadedMesh loaded = loadScaled(mesh, scale);
    const bool doubtful = !loaded.report.watertight || oddSize(loaded.report);
    for (const auto& remark : loaded.report.remarks) {
      remarks_.push_back(mesh.string() + ": " + remark);
      mesh_remarks_.push_back({remarks_.back(), doubtful});
    }
    std::string doubt;
    for (const auto& remark : loaded.report.remarks)
      if (oddSize(loaded.report) && remark.find("probably") != std::string::npos) doubt = remark;
    body = std::make_shared<Body>(Body{std::move(loaded.mesh), nullptr, std::move(doubt)});
  }
  return add(identity, mesh.stem().string(), body, options);
}

StructureLibrary::Key StructureLibrary::requestStored(const std::filesystem::path& file) {
  store::StoredBody stored = store::readStoredBody(file);
  const std::string identity = "structure:" + file.string();
  auto& body = bodies_[identity];
  if (!body) body = std::make_shared<Body>(Body{{}, std::move(stored.surface), {}});
  return add(identity, std::move(stored.name), body, stored.options);
}

StructureLibrary::Key StructureLibrary::take(std::shared_ptr<const structure::HapticStructure> made) {
  entries_.push_back({made->name, nullptr, made->options, made});
  return entries_.size() - 1;
}

void StructureLibrary::makeSurfaces(int threads) {
  std::vector<Body*> missing;
  for (const auto& [identity, body] : bodies_)
    if (!body->surface) missing.push_back(body.get());
  // Largest first, so that all cores finish at about the same time.
  std::stable_sort(missing.begin(), missing.end(), [](const Body* l, const Body* r) {
    return l->mesh.triangles.size() > r->mesh.triangles.size();
  });
  parallelFor(threads, missing.size(), [&](std::size_t i) {
    missing[i]->surface = store::makeSurface(cache_, std::move(missing[i]->mesh));
  });
}

void StructureLibrary::build(int threads, const structure::BuildMonitor& monitor) {
  const auto begin = std::chrono::steady_clock::now();
  makeSurfaces(threads);
  std::vector<Entry*> missing;
  for (Entry& e : entries_) {
    if (e.structure) continue;
    const double h = e.options.voxel_size, s = e.options.point_spacing;
    e.work = e.body->surface->area() * (1.0 / (h * h) + 1.0 / (s * s));
    missing.push_back(&e);
  }
  std::stable_sort(missing.begin(), missing.end(),
                   [](const Entry* l, const Entry* r) { return l->work > r->work; });
  std::vector<double> work;
  for (const Entry* e : missing) work.push_back(e->work);

  SharedProgress progress(monitor, work);
  std::atomic<std::size_t> cached{0};
  const int all = threads > 0 ? threads : static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  const int each = std::max(1, all / static_cast<int>(std::max<std::size_t>(1, missing.size())));
  parallelFor(threads, missing.size(), [&](std::size_t i) {
    Entry& e = *missing[i];
    try {
      const store::MadeStructure made = store::makeHapticStructure(cache_, e.name, e.body->surface, e.options,
                                                                   each, progress.part(i, e.name));
      e.structure = made.structure;
      if (made.cached) ++cached;
    } catch (const UsageError& error) {
      throw UsageError(e.name + ": " + error.what() +
                       (e.body->doubt.empty() ? "" : "\nhint: " + e.body->doubt));
    }
  });
  cached_ += cached;
  for (std::string& warning : cache_.takeWarnings()) remarks_.push_back(std::move(warning));
  build_ms_ += std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace abstand::session
