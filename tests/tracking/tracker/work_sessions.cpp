// One posture after the other.
#include "tests/tracking/tracker/work_sessions.hpp"

#include "tests/tracking/tracker/beside_things.hpp"

namespace abstand::testing {
namespace {

/// Each is reached `after` seconds and then held for `held` seconds.
void goOn(std::vector<Posture>& postures, Posture next, double after, double held) {
  next.t = postures.back().t + after;
  postures.push_back(next);
  if (held == 0.0) return;
  next.t += held;
  postures.push_back(next);
}

std::vector<Posture> work() {
  const Posture stands{};
  const Posture reaches{.reach = 0.40, .aside = 0.20, .low = 1.05};
  const Posture bends{.hips = {-0.20, 0.0, 0.70},
                      .loins = 1.0,
                      .back = 1.7,
                      .head = 1.9,
                      .reach = 0.35,
                      .aside = 0.15,
                      .low = 0.20};
  Posture kneels{
      .hips = {0.0, 0.0, 0.48}, .reach = 0.10, .low = 0.46, .foot = -0.38, .ankle = 0.09, .toes = -2.8};
  Posture works = kneels;
  works.reach = 0.35;
  works.low = 0.35;
  const Posture raises{.reach = 0.15, .aside = 0.30, .low = 1.95};
  const Posture squats{.hips = {-0.15, 0.0, 0.35},
                       .loins = 0.6,
                       .back = 0.6,
                       .reach = 0.30,
                       .aside = 0.25,
                       .low = 0.45,
                       .foot = 0.10,
                       .apart = 0.14};
  const Posture sits{
      .hips = {-0.44, 0.0, 0.50}, .back = 0.1, .reach = -0.14, .aside = 0.16, .low = 0.62, .apart = 0.12};
  const Posture spreads{.reach = 0.05, .aside = 0.75, .low = 1.45};
  std::vector<Posture> postures{stands};
  goOn(postures, stands, 2.0, 0.0);
  goOn(postures, reaches, 1.0, 2.0);
  goOn(postures, stands, 1.0, 0.0);
  goOn(postures, bends, 1.2, 1.0);
  goOn(postures, stands, 1.2, 0.0);
  goOn(postures, kneels, 1.4, 0.0);
  goOn(postures, works, 1.2, 0.0);
  goOn(postures, kneels, 2.0, 0.0);
  goOn(postures, stands, 1.5, 0.0);
  goOn(postures, raises, 1.2, 1.0);
  goOn(postures, stands, 1.3, 0.0);
  goOn(postures, squats, 1.2, 1.3);
  goOn(postures, stands, 1.5, 0.0);
  goOn(postures, sits, 1.5, 3.5);
  goOn(postures, stands, 1.5, 0.0);
  goOn(postures, spreads, 1.2, 0.0);
  goOn(postures, stands, 1.5, 0.0);
  return postures;
}

}  // namespace

std::vector<PosedScene> workSessions() {
  std::vector<PosedScene> scenes;
  for (const SideView& view : eightSides())
    scenes.push_back({.name = "session" + view.suffix,
                      .postures = work(),
                      .eye = view.eye,
                      .furniture = boxesOf(Thing::kChair, {-0.44, 0.0}),
                      .body_seed = 1});
  return scenes;
}

}  // namespace abstand::testing
