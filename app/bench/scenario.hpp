// Scenes of a peer benchmark: meshes, pairs and poses in plain files.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/geometry/triangle_mesh.hpp"

namespace abstand::bench {

/// A folder with `scenario.json` ({"name", "dt", "objects": [{"name", "mesh", "scale"}], "pairs": [[i, j],
/// ...]}) and `poses.csv` (no header; a row a frame, 12 numbers an object: the row-major 3x4 [R|t], object in
/// world, metres).
struct Scenario {
  struct Body {
    std::string name;
    std::filesystem::path mesh;
    double scale{1.0};  ///< metres a unit of the mesh
  };
  std::string name;
  double dt{0.001};  ///< s a frame
  std::vector<Body> bodies;
  std::vector<std::pair<int, int>> pairs;
  std::vector<Transform> X_WB;  ///< frame, then body

  std::size_t frames() const { return bodies.empty() ? 0 : X_WB.size() / bodies.size(); }
  const Transform* frame(std::size_t f) const { return &X_WB[f * bodies.size()]; }
};

/// Throws ParseError.
Scenario loadScenario(const std::filesystem::path& folder);

}  // namespace abstand::bench
