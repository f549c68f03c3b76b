// Predicts cost and accuracy of a resolution before it is built.
#pragma once

#include <memory>
#include <string>

#include "core/structure/haptic_structure.hpp"

namespace abstand::store {

/// Prediction for a build with given options; its accuracy is stated at ResolutionProbe.
struct ResolutionEstimate {
  structure::HapticOptions options;
  std::string refused;      ///< why it cannot be built; empty if it can, and only then the other members are
                            ///< valid
  double error_bound{0.0};  ///< m, upper bound of HapticStructure::errorBound()
  double memory_bytes{0.0};
  double points{0.0};
  double build_ms{0.0};     ///< on this machine under its current load, with all cores
  double distance_us{0.0};  ///< one query of two copies, apart by a tenth of the size
  double contact_us{0.0};   ///< one query of two copies, overlapping by a fiftieth of the size
};

/// Builds one body coarsely, measures the build, and extrapolates to any finer resolution:
///   points    area / (2 / sqrt(3) spacing^2), the pointshell's packing, plus b / spacing for edges and c for
///             tips and curvature, b and c from two coarse shells. Tests: within 25 %.
///   memory    near field: number of blocks, from the distance at (a sample of) their centres, times the
/// bytes
///             of a block; far field: vertices of its grids; shell and tree: bytes per point; layered: two
///             bytes per voxel of the grid. Tests: within 25 %.
///   error     the field's part is proportional to the voxel size, the shell's is at most kCovering spacings.
///   time      of the phases of the coarse build, scaled by numbers of voxels, blocks, vertices and points
/// with
///             empirical powers; points by the time of a sphere's points. Within a factor of two on an idle
///             machine; informative only.
///   queries   timed with the coarse body; a distance query grows with the square root of the number of
/// points,
///             the extra time of a contact query with its power 0.75. Within a factor of three.
/// A resolution coarser than the probe is built instead. Not thread-safe.
class ResolutionProbe {
 public:
  /// Upper bound of a shell's covering radius in spacings: hole filling leaves 0.775, and sub-triangles
  /// extend 0.3 beyond their centroid. Measured in tests: 0.95.
  static constexpr double kCovering = 1.1;

  explicit ResolutionProbe(std::shared_ptr<const geometry::Surface> surface) : surface_(std::move(surface)) {}

  /// Throws UsageError for options out of range, and BuildCancelled.
  ResolutionEstimate estimate(const structure::HapticOptions& options,
                              const structure::BuildMonitor& monitor = {});

 private:
  struct Coarse;
  const Coarse& coarse(const structure::HapticOptions& options, const structure::BuildMonitor& monitor);

  std::shared_ptr<const geometry::Surface> surface_;
  std::shared_ptr<const Coarse> coarse_;  ///< most recent coarse build
};

}  // namespace abstand::store
