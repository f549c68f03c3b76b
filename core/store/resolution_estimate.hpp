// What a resolution would cost, before it is built.
#pragma once

#include <memory>
#include <string>

#include "core/structure/haptic_structure.hpp"

namespace abstand::store {

/// What building with these options would give. Predictions; how good they are is said at ResolutionProbe.
struct ResolutionEstimate {
  structure::HapticOptions options;
  std::string refused;      ///< why it cannot be built; empty when it can, and only then the rest counts
  double error_bound{0.0};  ///< m, HapticStructure::errorBound() at most
  double memory_bytes{0.0};
  double points{0.0};
  double build_ms{0.0};     ///< on this machine as busy as it is now, with all its cores
  double distance_us{0.0};  ///< one query: two of the body, apart by a tenth of its size
  double contact_us{0.0};   ///< one query: two of the body, pressed into each other by a fiftieth
};

/// Builds one body coarsely, measures that, and scales it to any finer resolution:
///   points    area / (2 / sqrt(3) spacing^2), the pointshell's packing, plus b / spacing for edges and c for
///             tips and curvature, b and c from two coarse shells. Tests: within 25 %.
///   memory    near field: blocks counted by asking for the distance at (a sample of) their centres, times
///             the bytes of a block; far field: by the vertices of its grids; shell and tree: bytes a point;
///             layered: two bytes a voxel of the grid. Tests: within 25 %.
///   error     the field's part grows with the voxel, the shell's is kCovering spacings at most.
///   time      of the phases of the coarse build: voxels, blocks, vertices and points, each by its own count,
///             with powers that were found; points by the time that a ball's take. Good to a factor of two
///             on a quiet machine; nothing depends on it.
///   queries   of the coarse body, timed; a distance grows with the root of the number of points, what a
///             contact takes more with its power 0.75. Good to a factor of three.
/// A resolution that is coarser than the probe is built instead. Not shared between threads.
class ResolutionProbe {
 public:
  /// Covering radius of a shell in spacings, at most: filling leaves 0.775, the pieces that the surface is
  /// cut into reach 0.3 beyond their middle. Found in tests: 0.95.
  static constexpr double kCovering = 1.1;

  explicit ResolutionProbe(std::shared_ptr<const geometry::Surface> surface) : surface_(std::move(surface)) {}

  /// Throws UsageError for options out of their range, and BuildCancelled.
  ResolutionEstimate estimate(const structure::HapticOptions& options,
                              const structure::BuildMonitor& monitor = {});

 private:
  struct Coarse;
  const Coarse& coarse(const structure::HapticOptions& options, const structure::BuildMonitor& monitor);

  std::shared_ptr<const geometry::Surface> surface_;
  std::shared_ptr<const Coarse> coarse_;  ///< the last one
};

}  // namespace abstand::store
