// Scenes that every engine of the benchmarks answers: the same meshes, pairs and poses for all.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/geometry/triangle_mesh.hpp"
#include "core/structure/haptic_options.hpp"

namespace abstand::bench {

/// Meshes only, as the others know no shapes. World frame, metres.
struct BenchScene {
  struct Body {
    std::string name;
    geometry::TriangleMesh mesh;
  };
  std::string name;
  std::string what;                  ///< a few words for the table
  structure::HapticOptions options;  ///< of our structures
  std::vector<Body> bodies;
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  std::vector<Transform> X_WB;  ///< frame, then body
  std::size_t sparse{1};        ///< every so many frames are asked of engines that need milliseconds for one

  std::size_t frames() const { return X_WB.size() / bodies.size(); }
  const Transform* frame(std::size_t f) const { return &X_WB[f * bodies.size()]; }
  std::size_t triangles() const;
};

/// Made when first asked for; they stay. Throw ParseError when a file of the scene is not there.
/// data/scenes/spheres.yaml, two seconds at 1 kHz.
const BenchScene& threeSpheres();
/// data/scenes/rods.yaml, the two seconds before and in contact at 1 kHz.
const BenchScene& rods();
/// data/scenes/hug_boxing.yaml with the table of data/robots/hug before the column and the boxer 5 cm nearer,
/// so that fists come to the arms: two arms, a person, column and table, at the frames of the capture.
const BenchScene& armsPersonTable();
/// Two bumpy balls of some 70,000 triangles each, the size of the well-known bunny; one turns about the other
/// and into it, two seconds at 1 kHz.
const BenchScene& bunnyOnBunny();
/// A peg of radius 24.9 mm moves in a hole of 25.0 mm, with up to 0.04 mm of overlap; two seconds at 1 kHz.
const BenchScene& pegInHole();

}  // namespace abstand::bench
