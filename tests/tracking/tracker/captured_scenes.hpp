// Real captures, worn by a body of skin, as clips.
#pragma once

#include "tests/tracking/tracker/simulated_clip.hpp"

namespace abstand::testing {

struct CapturedScene {
  std::string name;
  ClipPlan plan;
  std::vector<FurnitureBox> furniture{};
};
SimulatedClip simulate(const CapturedScene& scene);

/// In full view. The captures may be missing on a machine.
std::vector<CapturedScene> capturedScenes();

/// Short ones in which limbs are hidden: from behind, from the side, hands on the hips; 240 x 180.
std::vector<CapturedScene> hardScenes();

/// The first two seconds of people whom a camera sees from each of eight directions, by angle in degrees from
/// their front to their left; 240 x 180.
std::vector<CapturedScene> scenesFromAllSides();

}  // namespace abstand::testing
