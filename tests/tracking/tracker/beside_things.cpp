// Things made of boxes.
#include "tests/tracking/tracker/beside_things.hpp"

#include "tests/support/paths.hpp"
#include "tests/tracking/tracker/postures.hpp"

namespace abstand::testing {
namespace {

std::vector<FurnitureBox> boxesAtOrigin(Thing thing) {
  switch (thing) {
    case Thing::kChair:
      return {{{-0.22, -0.22, 0.37}, {0.22, 0.22, 0.41}},
              {{-0.26, -0.22, 0.0}, {-0.22, 0.22, 0.95}},
              {{0.18, -0.22, 0.0}, {0.22, -0.18, 0.37}},
              {{0.18, 0.18, 0.0}, {0.22, 0.22, 0.37}}};
    case Thing::kCrate:
      return {{{-0.2, -0.2, 0.0}, {0.2, 0.2, 0.45}}};
    case Thing::kCart:
      return {{{-0.2, -0.25, 0.0}, {0.2, 0.25, 0.9}}};
    case Thing::kCupboard:
      return {{{-0.25, -0.3, 0.0}, {0.25, 0.3, 1.6}}};
    case Thing::kTable:
      return {{{-0.3, -0.4, 0.70}, {0.3, 0.4, 0.74}},
              {{-0.3, -0.4, 0.0}, {-0.26, -0.36, 0.70}},
              {{0.26, -0.4, 0.0}, {0.3, -0.36, 0.70}},
              {{-0.3, 0.36, 0.0}, {-0.26, 0.4, 0.70}},
              {{0.26, 0.36, 0.0}, {0.3, 0.4, 0.70}}};
    case Thing::kStand:
      return {{{-0.03, -0.03, 0.0}, {0.03, 0.03, 1.2}}, {{-0.15, -0.1, 1.2}, {0.15, 0.1, 1.4}}};
  }
  return {};
}

}  // namespace

std::vector<FurnitureBox> boxesOf(Thing thing, const Eigen::Vector2d& at) {
  std::vector<FurnitureBox> boxes = boxesAtOrigin(thing);
  for (FurnitureBox& box : boxes) {
    box.low.head<2>() += at;
    box.high.head<2>() += at;
  }
  return boxes;
}

std::vector<CapturedScene> scenesBesideThings() {
  constexpr double kLong = 2.0;  // s
  const struct {
    const char* name;
    Thing thing;
    double distance;  // m
    bool ahead;       // whether the hand passes above it
  } things[] = {{"chair", Thing::kChair, 0.60, true}, {"crate", Thing::kCrate, 0.55, true},
                {"cart", Thing::kCart, 0.65, true},   {"cupboard", Thing::kCupboard, 0.75, false},
                {"table", Thing::kTable, 0.85, true}, {"stand", Thing::kStand, 0.55, false}};
  std::vector<CapturedScene> scenes;
  for (const auto& [name, thing, distance, ahead] : things)
    for (int side = 0; side < 360; side += 45) {
      if (side == 0 && !ahead) continue;
      const double angle = unit::deg(static_cast<double>(side));
      const Eigen::Vector2d at = distance * Eigen::Vector2d(std::cos(angle), std::sin(angle));
      scenes.push_back({"beside_" + std::string(name) + "_at_" + std::to_string(side),
                        {.recording = projectFile("data/scenes/hug_reach.bvh"), .end = kLong, .room = true},
                        boxesOf(thing, at)});
    }
  return scenes;
}

std::vector<PosedScene> scenesCloseToThings() {
  const struct {
    const char* name;
    Thing thing;
    Eigen::Vector2d at;  // m
  } things[] = {{"chair", Thing::kChair, {-0.44, 0.0}},
                {"crate", Thing::kCrate, {0.0, 0.45}},
                {"cart", Thing::kCart, {0.45, 0.0}}};
  std::vector<PosedScene> scenes;
  for (const auto& [name, thing, at] : things)
    for (const SideView& view : eightSides())
      scenes.push_back({.name = "close_" + std::string(name) + view.suffix,
                        .postures = {standing(0.0), standing(1.0), handsAhead(2.0), handsAhead(3.0)},
                        .eye = view.eye,
                        .furniture = boxesOf(thing, at)});
  return scenes;
}

}  // namespace abstand::testing
