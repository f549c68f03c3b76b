// Scenes of a peer benchmark: meshes, pairs and poses in text files.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/geometry/triangle_mesh.hpp"

namespace abstand::bench {

/// A folder with `scenario.json` ({"name", "dt", "objects": [{"name", "mesh", "scale"}], "pairs": [[i, j],
/// ...]}) and `poses.csv` (no header; one row for each frame, 12 numbers for each object: the row-major 3x4
/// [R|t], object in world, metres).
struct Scenario {
  struct Body {
    std::string name;
    std::filesystem::path mesh;
    double scale{1.0};  ///< metres per unit of the mesh
  };
  std::string name;
  double dt{0.001};  ///< s for each frame
  std::vector<Body> bodies;
  std::vector<std::pair<int, int>> pairs;
  std::vector<Transform> X_WB;  ///< index order: frame, body

  std::size_t frames() const { return bodies.empty() ? 0 : X_WB.size() / bodies.size(); }
  const Transform* frame(std::size_t f) const { return &X_WB[f * bodies.size()]; }
};

/// Throws ParseError.
Scenario loadScenario(const std::filesystem::path& folder);

}  // namespace abstand::bench
