// Plane fitting by RANSAC. Wraps PCL.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "tracking/depth/people/floor_plane.hpp"

namespace abstand::tracking {

struct ConsensusOptions {
  double tilt{0.0};        ///< rad, largest tilt of a plane from the image's horizontal
  double certainty{0.99};  ///< probability of having drawn three points of the best plane, at which the
                           ///< search ends early
  int tries{0};            ///< largest number of triples drawn, including unmeasured ones
  std::uint64_t seed{1};
};

/// RANSAC (Fischler, Bolles 1981): of the level planes through three points near each other in the grid, the
/// one with the highest `count`. A count of 0 rejects a plane. Deterministic for a seed. nullopt if all are
/// rejected.
std::optional<FloorPlane> consensusPlane(const PointGrid& grid, const ConsensusOptions& options,
                                         const std::function<std::size_t(const FloorPlane&)>& count);

}  // namespace abstand::tracking
