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
  std::vector<PosedScene> scenes{
      {"very_tall", stand},
      {"very_tall_on_the_knees", kneel},
      {"very_tall_from_the_knees", {kneeling(0.0), kneeling(2.0), standing(3.0), standing(5.0)}},
      {"bowed_at_first", {bowed(0.0), bowed(2.0), standing(3.0), standing(5.0)}},
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
