// Builds everything the collision engine knows of one body.
#include "core/haptic/haptic_structure.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <mutex>
#include <utility>

#include "core/base/parallel.hpp"
#include "core/geometry/mesh_pieces.hpp"
#include "core/haptic/far_spacing.hpp"
#include "core/haptic/voxelmap_sides.hpp"

namespace abstand {
namespace {

// Voxels. Enough for depth-sized margins and for normals near the surface; the far field takes over beyond,
// where its own error is a small part of the distance.
constexpr double kBand = 4.0;
// m; how far the far field's grids reach: a person's reach and more. Beyond, distances to their box do.
constexpr double kFarReach = 2.0;
// Of a voxel: how closely a shape's triangles follow it, where triangles are needed.
constexpr double kSagitta = 0.1;

struct ShapeRadius {
  double operator()(const Sphere& s) const { return s.radius; }
  double operator()(const Ellipsoid& s) const { return s.semi_axes.maxCoeff(); }
  double operator()(const Cuboid& s) const { return 0.5 * s.size.norm(); }
  double operator()(const Cylinder& s) const { return std::hypot(s.radius, 0.5 * s.length); }
  double operator()(const Capsule& s) const { return s.radius + 0.5 * s.length; }
};

EnclosingSphere sphereAbout(const Surface& surface, const TriangleMesh& mesh) {
  if (const Shape* shape = surface.shape()) return {Vector3d::Zero(), std::visit(ShapeRadius{}, *shape)};
  std::vector<Vector3d> corners;
  corners.reserve(3 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (int i = 0; i < 3; ++i) corners.push_back(mesh.corner(t, i));
  }
  return minimalSphere(corners);
}

std::size_t bytesOf(const Pointshell& shell) { return 7 * sizeof(float) * shell.x.capacity(); }

std::size_t bytesOf(const PointSphereTree& tree) {
  return tree.nodes.capacity() * sizeof(PointSphereTree::Node) +
         tree.families.capacity() * sizeof(PointSphereTree::Family) + 7 * sizeof(float) * tree.x.capacity() +
         tree.shell_index.capacity() * sizeof(std::uint32_t);
}

/// Gives back what vectors hold beyond their size, through the lists of fields that archives use.
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

/// Tells the monitor of every loop of the build. The shares of the phases are those of a robot's link of
/// 5,000 triangles at 5 mm, roughly; they only make the bar steady.
class BuildWatch final : public LoopWatch {
 public:
  explicit BuildWatch(const BuildMonitor& monitor) : monitor_(monitor), before_(loop_watch) {
    if (monitor.progress || monitor.cancelled) loop_watch = this;
  }
  ~BuildWatch() override { loop_watch = before_; }

  void begin(std::string_view phase, double share) {
    start_ += share_;
    share_ = share;
    phase_ = phase;
    next(0, 1);
  }
  void end() {
    const std::scoped_lock lock(mutex_);
    report(1.0);
  }
  void next(std::size_t index, std::size_t count) override {
    if (monitor_.cancelled && monitor_.cancelled()) throw BuildCancelled();
    // Who comes while another reports has no more to say.
    const std::unique_lock lock(mutex_, std::try_to_lock);
    if (lock) report(start_ + share_ * static_cast<double>(index) / static_cast<double>(count));
  }

 private:
  void report(double fraction) {
    // A phase may have several loops, each from its own beginning.
    if (fraction < told_) return;
    told_ = fraction;
    if (monitor_.progress) monitor_.progress(fraction, phase_);
  }

  const BuildMonitor& monitor_;
  LoopWatch* before_;
  std::mutex mutex_;
  std::string_view phase_;
  double start_{0.0}, share_{0.0}, told_{0.0};
};

}  // namespace

double HapticStructure::errorBound() const {
  // The count of layers is certain to a voxel's diagonal, and its sign on the surface layer to half of one.
  const double layer_error = 1.5 * std::sqrt(3.0) * grid.voxel_size;
  return (near_field ? near_field->errorBound() : layer_error) + shell.covering_radius;
}

std::size_t HapticStructure::memoryBytes() const {
  std::size_t bytes =
      far_field.memoryBytes() + support.memoryBytes() + parts.memoryBytes() + bytesOf(shell) + bytesOf(tree);
  if (voxelmap) bytes += voxelmap->layer.capacity() * sizeof(std::int16_t);
  if (near_field) bytes += near_field->memoryBytes();
  return bytes;
}

FieldView HapticStructure::fieldView() const {
  FieldView view;
  view.far = far_field.view();
  if (near_field) {
    view.kind = FieldView::Kind::kNear;
    view.near = near_field->view();
    return view;
  }
  view.kind = FieldView::Kind::kLayered;
  view.voxel = static_cast<float>(voxelmap->grid.voxel_size);
  view.layer = voxelmap->layer.data();
  for (int k = 0; k < 3; ++k) {
    view.first_centre[k] = static_cast<float>(voxelmap->grid.first_centre[k]);
    view.size[k] = voxelmap->grid.size[k];
  }
  return view;
}

TreeView HapticStructure::treeView(const Transform& X_FP) const {
  TreeView view{tree.families.data(), tree.x.data(),    tree.y.data(),
                tree.z.data(),        tree.nx.data(),   tree.ny.data(),
                tree.nz.data(),       tree.area.data(), {}};
  for (int i = 0; i < 12; ++i) view.X_FP[i] = static_cast<float>(X_FP.matrix()(i / 4, i % 4));
  return view;
}

std::shared_ptr<const HapticStructure> buildHapticStructure(std::string name,
                                                            std::shared_ptr<const Surface> surface,
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
  const Bounds box = s.surface->bounds();
  const double h = options.voxel_size;
  s.grid = makeGrid(box, h, options.outer_layers);

  watch.begin("voxels", 0.1);
  if (options.field == FieldKind::kLayered) {
    s.voxelmap = makeVoxelmap(*s.surface, h, options.outer_layers, threads);
    s.surface_voxels = s.voxelmap->surface_voxels;
    s.solid_voxels = s.voxelmap->solid_voxels;
  } else {
    const VoxelSides sides = findVoxelSides(*s.surface, h, threads);
    s.surface_voxels = sides.surface_voxels;
    s.solid_voxels = sides.solid_voxels;
    watch.begin("near field", 0.4);
    s.near_field.emplace(*s.surface, s.grid, options.field == FieldKind::kMixed ? kBand * h : kInfinity,
                         threads);
  }
  watch.begin("far field", 0.1);
  s.far_field = FarField(*s.surface, farSpacing(box, h), kFarReach, threads);
  watch.begin("pointshell", 0.4);
  s.shell = makePointshell(*s.surface, options.point_spacing, threads);
  s.tree = makeTree(s.shell);

  s.mass_properties = s.surface->massProperties();
  s.com = s.mass_properties.com;
  const TriangleMesh mesh = s.surface->mesh(kSagitta * h);
  s.triangles = mesh.triangles.size();
  s.pieces = abstand::pieces(mesh);
  if (s.pieces.size() == 1) s.pieces.clear();
  s.bounding_sphere = sphereAbout(*s.surface, mesh);
  s.support = SupportMap(*s.surface, mesh, s.bounding_sphere.centre, threads);
  s.parts = s.surface->shape() ? SurfaceParts(s.bounding_sphere) : SurfaceParts(mesh, *s.surface);
  Shrink shrink;
  shrink(s.shell, s.tree, s.support, s.parts);
  watch.end();
  s.build_ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  return structure;
}

}  // namespace abstand
