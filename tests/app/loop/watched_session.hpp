// A live session of a slide, watched through its snapshots.
#pragma once

#include <chrono>
#include <cmath>
#include <thread>

#include "app/loop/live_session.hpp"
#include "tests/app/loop/slide_scene.hpp"

namespace abstand::testing {

struct WatchedSession {
  explicit WatchedSession(const std::string& reaction, const std::string& more = "", double to = 0.05,
                          double t = 0.0)
      : slide(reaction, thingComesTo(to), more), live(std::move(slide.session), t) {}

  /// Sees snapshots until the condition holds. Generous: a sanitizer build on a loaded machine is slow, and
  /// nothing here is about time.
  template <class Condition>
  bool waitFor(Condition condition) {
    for (int i = 0; i < 6000; ++i) {
      live.takeSnapshot(seen);
      if (seen.step > 0 && condition()) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return false;
  }
  bool waitForTime(double t) {
    return waitFor([&] { return std::abs(seen.t - t) < 1e-9; });
  }

  SlideScene slide;
  loop::LiveSession live;
  view::SceneSnapshot seen;
};

}  // namespace abstand::testing
