// How the time of a scene follows wall time while it plays.
#pragma once

#include "core/math/transform.hpp"

namespace abstand::loop {

/// Scene time is due as wall time passes, times the speed; nothing is due twice and nothing is dropped, but
/// for a lag of more than kMaxLag of wall time, which is given up as a whole: then play is slower than asked
/// for, and factor() says so. One thread; wall times are in s and never fall.
class PlayPace {
 public:
  static constexpr double kMaxLag = 0.25;       ///< s of wall time
  static constexpr double kFactorWindow = 0.5;  ///< s of wall time over which factor() is measured

  /// Playing begins: nothing is due at `wall`.
  void start(double wall) {
    last_ = mark_ = wall;
    due_ = played_ = 0.0;
    factor_ = kNaN;
  }
  /// A jump of the scene's time: what was due belongs to where it was.
  void drop() { due_ = 0.0; }
  /// Wall time is `wall`: more is due, at this speed since the last call.
  void advance(double wall, double speed) {
    due_ += speed * (wall - last_);
    last_ = wall;
    if (wall - mark_ < kFactorWindow) return;
    factor_ = played_ / (wall - mark_);
    mark_ = wall;
    played_ = 0.0;
  }
  /// Gives up a lag that is too long but for `keep` s of scene time.
  void forgive(double speed, double keep) {
    if (due_ > speed * kMaxLag) due_ = keep;
  }
  double due() const { return due_; }  ///< s of scene time
  /// So much of it was played, s.
  void played(double dt) {
    due_ -= dt;
    played_ += dt;
  }
  /// Scene time played by wall time, over the last window; NaN before the first one has passed.
  double factor() const { return factor_; }

 private:
  double last_{0.0}, mark_{0.0}, due_{0.0}, played_{0.0};
  double factor_{kNaN};
};

}  // namespace abstand::loop
