// What to know of a structure before trusting its numbers.
#pragma once

#include <optional>

#include "core/structure/haptic_structure.hpp"

namespace abstand::store {

/// Body frame, SI.
struct BuildReport {
  /// Edges through which inside leaks out; none for a shape. As in MeshReport.
  std::size_t open_edges{0}, non_manifold_edges{0}, flipped_edges{0};
  /// The mesh is no boundary of a solid (open, or it cuts itself), so winding numbers decided what is inside.
  bool inside_doubtful{false};

  /// Walls through which a point may slip from one side to the other: fields of this voxel size hardly see
  /// them. Seen along the inward normals of the shell points, so walls narrower than the points' spacing may
  /// be missed.
  struct ThinWalls {
    double below{0.0};      ///< m: two voxels
    double share{0.0};      ///< of the body's area, 0 to 1
    double thinnest{kNaN};  ///< m; NaN where no wall is below
    Vector3d where{Vector3d::Constant(kNaN)};
  };
  ThinWalls thin_walls;

  /// What a convex hull in place of the body would have got wrong.
  struct Hull {
    double volume_ratio{kNaN};  ///< hull over body, 1 for a convex body; NaN for a mesh that holds no volume
    /// The largest depth of the surface inside its hull (m): there a hull reports a contact so deep where the
    /// body is only touched. At the shell points, so it may be larger by the covering radius.
    double worst{0.0};
    Vector3d where{Vector3d::Constant(kNaN)};
  };
  std::optional<Hull> hull;  ///< none for a flat mesh
};

BuildReport reportOn(const structure::HapticStructure& structure);

}  // namespace abstand::store
