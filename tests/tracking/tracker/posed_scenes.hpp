// Written postures beside furniture and at the edge of the image, as clips.
#pragma once

#include <ostream>

#include "tests/tracking/tracker/posed_person.hpp"
#include "tests/tracking/tracker/simulated_clip.hpp"

namespace abstand::testing {

struct PosedScene {
  std::string name;
  std::vector<Posture> postures;
  Vector3d eye{2.8, 0.0, 1.2}, look{0.0, 0.0, 0.9};  ///< m
  std::vector<FurnitureBox> furniture{};
  std::uint64_t body_seed{0};
  std::vector<HeldBox> held{};
  double stature{kPosedStature};  ///< m; postures and furniture are scaled to it
};

inline void PrintTo(const PosedScene& scene, std::ostream* out) { *out << scene.name; }

std::vector<PosedScene> posedScenes();

/// People of other statures and shapes, postures, and views; no constant of the tracker was chosen with them,
/// except with those who are curled up, lie on the front or sit.
std::vector<PosedScene> heldOutScenes();
/// People of 1.15 to 2.0 m, and such who stoop, kneel or raise their hands at first, so that their height in
/// the images is not their stature.
std::vector<PosedScene> otherStatures();
/// Five positions of both hands at or above the head, seen from eight sides: from the start (`hands_...`),
/// and raised after a second (`raising_...`). 80 clips of 2.5 s.
std::vector<PosedScene> raisedScenes();

/// Seated, kneeling, behind a bench, bending, squatting and changing to and from these, seen from eight
/// sides. 64 clips of 2.5 to 3 s.
std::vector<PosedScene> posturesFromAllSides();

/// Standing, seated, kneeling and bending, seen from eight sides by cameras that are low (0.5 m high, 2.5 m
/// away), above (2.8 m; 1.5 m), high (2.8 m; 4 m) and far (1.2 m; 5 m). 128 clips of 2.5 to 3 s.
std::vector<PosedScene> posturesFromOtherPlaces();

/// People who hold bars and boxes.
std::vector<PosedScene> heldScenes();

/// Other people with other things; no constant of the tracker was chosen with them, except
/// HeldThings::kMemory.
std::vector<PosedScene> heldOutHeldScenes();
/// People on a chair who hold things.
std::vector<PosedScene> seatedHeldScenes();

/// In a room, 320 x 240.
SimulatedClip simulate(const PosedScene& scene);

}  // namespace abstand::testing
