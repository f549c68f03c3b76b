// Planes by sample consensus. The fence around PCL.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "tracking/depth/people/floor_plane.hpp"

namespace abstand::tracking {

struct ConsensusOptions {
  double tilt{0.0};        ///< rad, that a plane may lean by from the image's level
  double certainty{0.99};  ///< of having drawn three points of the best plane, before the search ends early
  int tries{0};            ///< triples that are drawn at most, unmeasured ones included
  std::uint64_t seed{1};
};

/// Of the level planes through three points that lie near each other in the grid, the one on which `count`
/// finds the most points (RANSAC; Fischler, Bolles 1981). A count of 0 refuses a plane. The same for the same
/// seed. Nothing where all are refused.
std::optional<FloorPlane> consensusPlane(const PointGrid& grid, const ConsensusOptions& options,
                                         const std::function<std::size_t(const FloorPlane&)>& count);

}  // namespace abstand::tracking
