// Builds the collision data of one body.
#include "core/structure/haptic_structure.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <mutex>
#include <utility>

#include "core/base/parallel.hpp"
#include "core/field/far_spacing.hpp"
#include "core/field/voxelmap_sides.hpp"
#include "core/geometry/mesh_pieces.hpp"

namespace abstand::structure {
namespace {

// In voxels. Enough for margins of the size of contact depths and for normals near the surface; beyond, the
// far field's error is a small share of the distance.
constexpr double kBand = 4.0;
// m; extent of the far field's grids beyond the body: more than a person's reach. Beyond, the distance to a
// ball is used.
constexpr double kFarReach = 2.0;
// Share of a voxel: sagitta of a shape's triangles, where triangles are needed.
constexpr double kSagitta = 0.1;

struct ShapeRadius {
  double operator()(const geometry::Sphere& s) const { return s.radius; }
  double operator()(const geometry::Ellipsoid& s) const { return s.semi_axes.maxCoeff(); }
  double operator()(const geometry::Cuboid& s) const { return 0.5 * s.size.norm(); }
  double operator()(const geometry::Cylinder& s) const { return std::hypot(s.radius, 0.5 * s.length); }
  double operator()(const geometry::Capsule& s) const { return s.radius + 0.5 * s.length; }
};

geometry::EnclosingSphere sphereAbout(const geometry::Surface& surface, const geometry::TriangleMesh& mesh) {
  if (const geometry::Shape* shape = surface.shape())
    return {Vector3d::Zero(), std::visit(ShapeRadius{}, *shape)};
  std::vector<Vector3d> corners;
  corners.reserve(3 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (int i = 0; i < 3; ++i) corners.push_back(mesh.corner(t, i));
  }
  return geometry::minimalSphere(corners);
}

std::size_t bytesOf(const shell::Pointshell& shell) { return 7 * sizeof(float) * shell.x.capacity(); }

std::size_t bytesOf(const shell::PointSphereTree& tree) {
  return tree.nodes.capacity() * sizeof(shell::PointSphereTree::Node) +
         tree.families.capacity() * sizeof(shell::PointSphereTree::Family) +
         7 * sizeof(float) * tree.x.capacity() + tree.shell_index.capacity() * sizeof(std::uint32_t);
}

/// Releases unused capacity of vectors, by the field lists that archives use.
struct Shrink {
  template <class... Fields>
  void operator()(Fields&... fields) {
    (field(fields), ...);
  }
  template <class T>
  void field(T& value) {
    if constexpr (requires { value.archive(*this); }) {
      value.archive(*this);
    } else if constexpr (requires { value.shrink_to_fit(); }) {
      value.shrink_to_fit();
    }
  }
};

/// Collects the progress of concurrent phases and reports to the monitor: total share done, and the name of
/// the first phase that is not finished.
class BuildWatch {
 public:
  explicit BuildWatch(const BuildMonitor& monitor) : monitor_(monitor) {}
  bool listens() const { return monitor_.progress || monitor_.cancelled; }
  void stopIfCancelled() {
    if (!monitor_.cancelled) return;
    const std::scoped_lock lock(mutex_);
    // Cancellation is final: the monitor is not polled again.
    if (cancelled_ || (cancelled_ = monitor_.cancelled())) throw BuildCancelled();
  }
  /// Starts a phase; reported to the monitor by this name.
  void begin(std::string_view name) {
    const std::scoped_lock lock(mutex_);
    name_ = name;
    report();
  }
  /// `more`: additional share of the whole that is done.
  void advance(double more) {
    const std::scoped_lock lock(mutex_);
    done_ += more;
    report();
  }
  /// Reports completion, whatever the shares add up to.
  void end() {
    const std::scoped_lock lock(mutex_);
    done_ = 1.0;
    report();
  }

 private:
  void report() const {
    if (monitor_.progress) monitor_.progress(std::min(done_, 1.0), name_);
  }

  const BuildMonitor& monitor_;
  std::mutex mutex_;
  std::string_view name_{"voxels"};
  double done_{0.0};
  bool cancelled_{false};
};

/// Watches every loop of one phase during its lifetime. The shares of the phases are roughly those of a robot
/// link of 5,000 triangles at 5 mm; they only make the progress steady.
class BuildPhase final : public LoopWatch {
 public:
  BuildPhase(BuildWatch& watch, double share) : watch_(watch), share_(share), before_(loop_watch) {
    watch_.stopIfCancelled();
    if (watch_.listens()) loop_watch = this;
  }
  ~BuildPhase() override { loop_watch = before_; }
  /// Marks the phase as finished.
  void end() { advance(1.0); }

  void next(std::size_t index, std::size_t count) override {
    watch_.stopIfCancelled();
    advance(static_cast<double>(index) / static_cast<double>(count));
  }

 private:
  void advance(double to) {
    // Skips a report while another thread reports, except for the last one.
    std::unique_lock lock(mutex_, std::defer_lock);
    if (to < 1.0 ? !lock.try_lock() : (lock.lock(), false)) return;
    // A phase may have several loops, each starting at 0.
    if (to <= done_) return;
    watch_.advance(share_ * (to - done_));
    done_ = to;
  }

  BuildWatch& watch_;
  double share_;
  LoopWatch* before_;
  std::mutex mutex_;
  double done_{0.0};
};

}  // namespace

double HapticStructure::errorBound() const {
  // The number of layers is certain to a voxel diagonal, and the sign on the surface layer to half of one.
  const double layer_error = 1.5 * std::sqrt(3.0) * grid.voxel_size;
  return (near_field ? near_field->errorBound() : layer_error) + shell.covering_radius;
}

std::size_t HapticStructure::memoryBytes() const {
  std::size_t bytes =
      far_field.memoryBytes() + support.memoryBytes() + parts.memoryBytes() + bytesOf(shell) + bytesOf(tree);
  if (voxelmap) bytes += voxelmap->memoryBytes();
  if (near_field) bytes += near_field->memoryBytes();
  return bytes;
}

kernels::FieldView HapticStructure::fieldView() const {
  kernels::FieldView view;
  view.far = far_field.view();
  if (near_field) {
    view.kind = kernels::FieldView::Kind::kNear;
    view.near = near_field->view();
    return view;
  }
  view.kind = kernels::FieldView::Kind::kLayered;
  view.voxel = static_cast<float>(voxelmap->grid.voxel_size);
  view.layers = voxelmap->view();
  for (int k = 0; k < 3; ++k) {
    view.first_centre[k] = static_cast<float>(voxelmap->grid.first_centre[k]);
    view.size[k] = voxelmap->grid.size[k];
  }
  return view;
}

kernels::TreeView HapticStructure::treeView(const Transform& X_FP) const {
  kernels::TreeView view{tree.families.data(), tree.x.data(),    tree.y.data(),
                         tree.z.data(),        tree.nx.data(),   tree.ny.data(),
                         tree.nz.data(),       tree.area.data(), {}};
  for (int i = 0; i < 12; ++i) view.X_FP[i] = static_cast<float>(X_FP.matrix()(i / 4, i % 4));
  return view;
}

std::shared_ptr<const HapticStructure> buildHapticStructure(std::string name,
                                                            std::shared_ptr<const geometry::Surface> surface,
                                                            const HapticOptions& options, int threads,
                                                            const BuildMonitor& monitor) {
  const auto start = std::chrono::steady_clock::now();
  options.validate();
  BuildWatch watch(monitor);
  auto structure = std::make_shared<HapticStructure>();
  HapticStructure& s = *structure;
  s.name = std::move(name);
  s.options = options;
  s.surface = std::move(surface);
  const geometry::Bounds box = s.surface->bounds();
  const double h = options.voxel_size;
  s.grid = field::makeGrid(box, h, options.outer_layers);

  const auto makeFields = [&] {
    watch.begin("voxels");
    BuildPhase voxels(watch, 0.1);
    if (options.field == FieldKind::kLayered) {
      s.voxelmap.emplace(*s.surface, h, options.outer_layers, threads);
      s.surface_voxels = s.voxelmap->surface_voxels;
      s.solid_voxels = s.voxelmap->solid_voxels;
      voxels.end();
    } else {
      const field::VoxelCounts counts = field::countVoxels(*s.surface, h, threads);
      s.surface_voxels = counts.surface;
      s.solid_voxels = counts.solid;
      voxels.end();
      watch.begin("near field");
      BuildPhase near(watch, 0.4);
      s.near_field.emplace(*s.surface, s.grid, options.field == FieldKind::kMixed ? kBand * h : kInfinity,
                           threads);
      near.end();
    }
    watch.begin("far field");
    BuildPhase far(watch, 0.1);
    s.far_field = field::FarField(*s.surface, field::farSpacing(box, h), kFarReach, threads);
    far.end();
    watch.begin("pointshell");
  };
  const auto makePoints = [&] {
    BuildPhase points(watch, 0.4);
    s.shell = shell::makePointshell(*s.surface, options.point_spacing, threads);
    s.tree = shell::makeTree(s.shell);

    s.mass_properties = s.surface->massProperties();
    s.com = s.mass_properties.com;
    const geometry::TriangleMesh mesh = s.surface->mesh(kSagitta * h);
    s.triangles = mesh.triangles.size();
    s.pieces = abstand::geometry::pieces(mesh);
    if (s.pieces.size() == 1) s.pieces.clear();
    s.bounding_sphere = sphereAbout(*s.surface, mesh);
    s.support = SupportMap(*s.surface, mesh, s.bounding_sphere.centre, threads);
    s.parts = s.surface->shape() ? SurfaceParts(s.bounding_sphere) : SurfaceParts(mesh, *s.surface);
    points.end();
  };
  // Much of the shell is built by a single thread; the fields keep the others busy.
  parallelFor(threads, 2, [&](std::size_t part) { part == 0 ? makeFields() : makePoints(); });
  Shrink shrink;
  shrink(s.shell, s.tree, s.support, s.parts);
  if (s.voxelmap) shrink(*s.voxelmap);
  watch.end();
  s.build_ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  return structure;
}

}  // namespace abstand::structure
