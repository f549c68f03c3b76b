// Quality report of a haptic structure.
#pragma once

#include <optional>

#include "core/structure/haptic_structure.hpp"

namespace abstand::store {

/// Body frame, SI.
struct BuildReport {
  /// Defective edges as in MeshReport; 0 for a shape.
  std::size_t open_edges{0}, non_manifold_edges{0}, flipped_edges{0};
  /// The mesh is not the boundary of a solid (open, or it intersects itself), so winding numbers decided what
  /// is inside.
  bool inside_doubtful{false};

  /// Walls thinner than two voxels, which fields of this voxel size hardly represent: a point may pass
  /// through. Measured along the inward normals of the shell points, so walls narrower than the point spacing
  /// may be missed.
  struct ThinWalls {
    double below{0.0};      ///< m: threshold, two voxels
    double share{0.0};      ///< of the body's area, 0 to 1
    double thinnest{kNaN};  ///< m; NaN if no wall is below the threshold
    Vector3d where{Vector3d::Constant(kNaN)};
  };
  ThinWalls thin_walls;

  /// Error of a convex hull used instead of the body.
  struct Hull {
    double volume_ratio{kNaN};  ///< hull over body, 1 for a convex body; NaN for a mesh that encloses no
                                ///< volume
    /// Largest depth of the surface inside its hull (m): the false contact depth that a hull reports where
    /// the body is only touched. Measured at the shell points, so the true value may be larger by the
    /// covering radius.
    double worst{0.0};
    Vector3d where{Vector3d::Constant(kNaN)};
  };
  std::optional<Hull> hull;  ///< none for a flat mesh
};

BuildReport reportOn(const structure::HapticStructure& structure);

}  // namespace abstand::store
