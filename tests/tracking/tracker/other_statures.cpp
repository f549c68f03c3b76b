// People of unusual stature, and of a stature that their first posture does not show.
#include "tests/tracking/tracker/posed_scenes.hpp"
#include "tests/tracking/tracker/postures.hpp"

namespace abstand::testing {
namespace {

constexpr double kVeryTall = 2.0, kChild = 1.30, kSmallChild = 1.15;  // m

/// Bowed by a third, as over a table.
Posture bowed(double t) {
  return {
      .t = t, .hips = {-0.12, 0.0, 0.9}, .loins = 0.5, .back = 0.8, .head = 0.6, .reach = 0.4, .low = 0.8};
}
/// As over a map in the hands: 8 cm lower than upright.
Posture slightlyBowed(double t) {
  return {
      .t = t, .hips = {-0.05, 0.0, 0.91}, .loins = 0.25, .back = 0.4, .head = 0.5, .reach = 0.3, .low = 1.0};
}
/// On a box of 0.15 m, 0.55 m ahead.
Posture onABox(double t) {
  return {.t = t, .hips = {0.55, 0.0, 1.072}, .reach = 0.59, .low = 1.03, .foot = 0.55, .ankle = 0.218};
}
Posture handsUp(double t) { return {.t = t, .reach = 0.15, .aside = 0.30, .low = 2.0}; }

}  // namespace

std::vector<PosedScene> otherStatures() {
  const std::vector<Posture> stand{standing(0.0), handsAhead(1.5), standing(3.0)};
  const std::vector<Posture> kneel{kneeling(0.0), kneeling(3.0)};
  const Vector3d eye{2.8, 0.0, 1.2}, look{0.0, 0.0, 0.9};
  // A bench that is 0.75 m high.
  constexpr double kOfChild = kPosedStature / kChild;
  const std::vector<FurnitureBox> bench{
      {{0.25 * kOfChild, -1.2 * kOfChild, 0.0}, {0.75 * kOfChild, 1.2 * kOfChild, 0.75 * kOfChild}}};
  const std::vector<FurnitureBox> box{{{0.3, -0.3, 0.0}, {0.8, 0.3, 0.15}}};
  std::vector<PosedScene> scenes{
      {"very_tall", stand},
      {"very_tall_on_the_knees", kneel},
      {"very_tall_from_the_knees", {kneeling(0.0), kneeling(2.0), standing(3.0), standing(5.0)}},
      {"bowed_at_first", {bowed(0.0), bowed(2.0), standing(3.0), standing(5.0)}},
      {"slightly_bowed_at_first", {slightlyBowed(0.0), slightlyBowed(2.0), standing(3.0), standing(5.0)}},
      {"up_a_box", {standing(0.0), standing(1.5), onABox(2.5), onABox(4.5)}, eye, look, box},
      {"child", stand},
      {"child_on_the_knees", kneel},
      {"child_with_raised_hands", {handsUp(0.0), handsUp(2.0), standing(4.0)}},
      {"child_behind_a_bench", stand, {2.8, 0.0, 1.5}, look, bench},
      {"small_child", stand}};
  for (PosedScene& scene : scenes)
    scene.stature = scene.name.starts_with("very_tall") ? kVeryTall
                    : scene.name.starts_with("child")   ? kChild
                    : scene.name == "small_child"       ? kSmallChild
                                                        : kPosedStature;
  return scenes;
}

}  // namespace abstand::testing
