// Somebody who stands beside a thing that is there from the first image on.
#pragma once

#include "tests/tracking/tracker/captured_scenes.hpp"
#include "tests/tracking/tracker/posed_scenes.hpp"

namespace abstand::testing {

enum class Thing : std::uint8_t {
  kChair,     ///< with a back of 0.95 m, which faces away from the camera's side of the origin
  kCrate,     ///< 0.4 x 0.4 x 0.45 m
  kCart,      ///< 0.4 x 0.5 x 0.9 m
  kCupboard,  ///< 0.5 x 0.6 x 1.6 m
  kTable,     ///< 0.6 x 0.8 x 0.74 m, on four legs
  kStand      ///< a box of 0.3 x 0.2 x 0.2 m on a post, up to 1.4 m: a camera, a screen
};
/// With the middle at `at` (m, world).
std::vector<FurnitureBox> boxesOf(Thing thing, const Eigen::Vector2d& at);

/// Two seconds of somebody who reaches ahead at the origin, seen from the front. Each thing, 0.55 to 0.85 m
/// away in eight directions (degrees from the front to the left), without the two in which the hand would
/// touch it: `beside_chair_at_45`.
std::vector<CapturedScene> scenesBesideThings();

/// Three seconds of somebody who stands and reaches ahead, 0.1 m from a thing: a chair behind, a crate to the
/// left, a cart ahead. In the image their surfaces adjoin. Each from eight sides: `close_chair_from_45`.
std::vector<PosedScene> scenesCloseToThings();

}  // namespace abstand::testing
