#include "ui/model/level_times.hpp"

#include <algorithm>
#include <cmath>

namespace abstand::ui {

namespace {
/// s: a longer step from one shown moment to the next is a jump; so much does not pass unseen while playing
/// at the highest speed.
constexpr double kJump = 0.5;
constexpr double kFrames = 1.5;  // of the recording: while it does not play, a step of one frame is none
}  // namespace

void LevelTimes::clear() {
  entries_.clear();
  last_ = kNaN;
}

void LevelTimes::add(const view::SceneOutline& outline, const view::SceneSnapshot& snapshot) {
  const std::size_t pairs = std::min(outline.pairs.size(), snapshot.pairs.size());
  const double step = snapshot.t - last_;
  const bool follows = entries_.size() == pairs && step >= 0.0 &&
                       step <= (snapshot.playing ? kJump : kFrames * outline.frame_period);
  entries_.resize(pairs);
  for (std::size_t p = 0; p < pairs; ++p) {
    const PairLevel level = pairLevel(snapshot, snapshot.pairs[p], outline.pairs[p]);
    Entry& entry = entries_[p];
    if (follows && entry.level == level) continue;
    // A change at one moment, by a margin, begins there, too.
    entry = {level, {snapshot.t, follows}};
  }
  last_ = snapshot.t;
}

LevelTimes::Since LevelTimes::of(int pair) const {
  const auto p = static_cast<std::size_t>(pair);
  return pair >= 0 && p < entries_.size() ? entries_[p].since : Since{};
}

}  // namespace abstand::ui
