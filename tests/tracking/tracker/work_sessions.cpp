// One posture after the other.
#include "tests/tracking/tracker/work_sessions.hpp"

#include "tests/tracking/tracker/beside_things.hpp"
#include "tests/tracking/tracker/postures.hpp"

namespace abstand::testing {
namespace {

constexpr double kChairAt = -0.44;  // m, behind who stands

/// Each is reached `after` seconds and then held for `held` seconds.
void goOn(std::vector<Posture>& postures, Posture next, double after, double held) {
  next.t = postures.back().t + after;
  postures.push_back(next);
  if (held == 0.0) return;
  next.t += held;
  postures.push_back(next);
}

std::vector<Posture> work() {
  const Posture stands = standing(0.0), reaches = handsAhead(0.0), bends = bent(0.0), kneels = kneeling(0.0),
                raises = armsUp(0.0), squats = squatting(0.0), spreads = armsAside(0.0);
  Posture works = kneels;
  works.reach = 0.35;
  works.low = 0.35;
  Posture sits = seated(0.0);
  sits.hips.x() = kChairAt;
  sits.reach = -0.14;
  sits.foot = 0.0;
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
                      .furniture = boxesOf(Thing::kChair, {kChairAt, 0.0}),
                      .body_seed = 1});
  return scenes;
}

}  // namespace abstand::testing
