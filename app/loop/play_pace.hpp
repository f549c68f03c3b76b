// Relates scene time to wall time while playing.
#pragma once

#include "core/math/transform.hpp"

namespace abstand::loop {

/// Scene time becomes due with wall time, times the speed; nothing is due twice or dropped, except for a lag
/// of more than kMaxLag of wall time, which is dropped as a whole: play is then slower than requested, and
/// factor() shows it. One thread; wall times (s) never decrease.
class PlayPace {
 public:
  static constexpr double kMaxLag = 0.25;       ///< s of wall time
  static constexpr double kFactorWindow = 0.5;  ///< s of wall time over which factor() is measured

  /// Starts playing: nothing is due at `wall`.
  void start(double wall) {
    last_ = mark_ = wall;
    due_ = played_ = 0.0;
    factor_ = kNaN;
  }
  /// After a jump of the scene time: discards what was due.
  void drop() { due_ = 0.0; }
  /// Advances wall time to `wall` at this speed since the last call.
  void advance(double wall, double speed) {
    due_ += speed * (wall - last_);
    last_ = wall;
    if (wall - mark_ < kFactorWindow) return;
    factor_ = played_ / (wall - mark_);
    mark_ = wall;
    played_ = 0.0;
  }
  /// Drops a lag that is too long, except for `keep` s of scene time.
  void limitLag(double speed, double keep) {
    if (due_ > speed * kMaxLag) due_ = keep;
  }
  double due() const { return due_; }  ///< s of scene time
  /// Subtracts `dt` s of scene time that was played.
  void played(double dt) {
    due_ -= dt;
    played_ += dt;
  }
  /// Scene time played over wall time, over the last window; NaN before the first window has passed.
  double factor() const { return factor_; }

 private:
  double last_{0.0}, mark_{0.0}, due_{0.0}, played_{0.0};
  double factor_{kNaN};
};

}  // namespace abstand::loop
