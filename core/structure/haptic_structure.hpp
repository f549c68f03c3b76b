// Collision data of one body: voxelmap, pointshell, distance fields.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "core/field/voxelmap.hpp"
#include "core/kernels/field_view.hpp"
#include "core/structure/build_progress.hpp"
#include "core/structure/haptic_options.hpp"
#include "core/structure/support_map.hpp"
#include "core/structure/surface_parts.hpp"

namespace abstand::structure {

/// Voxelmap and pointshell of one body [thesis 4.2.2] with its exact surface. Constant after construction and
/// shared by objects of the same shape. Body frame, metres.
struct HapticStructure {
  std::string name;
  HapticOptions options;
  std::shared_ptr<const geometry::Surface> surface;
  std::optional<field::Voxelmap> voxelmap;     ///< field: layered (and where requested)
  std::optional<field::NearField> near_field;  ///< field: float and mixed
  field::FarField far_field;
  SupportMap support;
  SurfaceParts parts;  ///< for meshes
  shell::Pointshell shell;
  shell::PointSphereTree tree;
  kernels::FieldView
      field_view;  ///< of the fields above; views point into the members, so a structure stays where it is
  kernels::TreeView tree_view;

  geometry::MassProperties mass_properties;  ///< density 1
  Vector3d com{Vector3d::Zero()};            ///< reference point of torques
  std::vector<Vector3d> pieces;  ///< one point of each connected component of the surface; empty if there is
                                 ///< only one
  geometry::EnclosingSphere bounding_sphere;  ///< of the surface, not only of its points
  field::VoxelGrid grid;                      ///< effective grid, for any kind of field
  std::size_t surface_voxels{0};
  std::size_t solid_voxels{0};
  std::size_t triangles{0};
  double build_ms{0.0};

  /// Bound on the error of one field value near the surface plus the covering radius of the shell (m).
  double errorBound() const;
  std::size_t memoryBytes() const;
  /// Views for searches; they point into the members.
  kernels::FieldView fieldView() const;
  kernels::TreeView treeView(const Transform& X_FP) const;
  /// Archives all members except name and surface.
  template <class Archive>
  void archive(Archive& ar) {
    ar(options, voxelmap, near_field, far_field, support, parts, shell, tree, mass_properties.volume,
       mass_properties.com, mass_properties.inertia, com, pieces, bounding_sphere.centre,
       bounding_sphere.radius, grid, surface_voxels, solid_voxels, triangles, build_ms);
  }
};

/// The near field, or null for a layered field.
inline const field::NearField* nearField(const HapticStructure& structure) {
  return structure.near_field ? &*structure.near_field : nullptr;
}

/// Builds all parts of a structure on `threads` threads (0: all). The result does not depend on their number.
/// Throws UsageError for options that do not fit the body, and BuildCancelled if the monitor cancels.
std::shared_ptr<const HapticStructure> buildHapticStructure(std::string name,
                                                            std::shared_ptr<const geometry::Surface> surface,
                                                            const HapticOptions& options, int threads = 0,
                                                            const BuildMonitor& monitor = {});

}  // namespace abstand::structure
