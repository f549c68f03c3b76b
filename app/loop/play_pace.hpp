// Relates scene time to wall time while playing.
#pragma once

#include <algorithm>
#include <array>

#include "core/math/transform.hpp"

namespace abstand::loop {

/// Scene time becomes due with wall time, times the speed; nothing is due twice or dropped, except for a lag
/// of more than kMaxLag of wall time, which is dropped as a whole: play is then slower than requested, and
/// factor() shows it. One thread; wall times (s) never decrease.
class PlayPace {
 public:
  static constexpr double kMaxLag = 0.25;  ///< s of wall time
  /// factor() is measured over so many of these parts of wall time (s), so that it neither jumps nor lags.
  static constexpr std::size_t kParts = 6;
  static constexpr double kPart = 0.25;

  /// Starts playing: nothing is due at `wall`.
  void start(double wall) {
    last_ = mark_ = wall;
    due_ = played_ = 0.0;
    parts_ = 0;
  }
  /// After a jump of the scene time: discards what was due.
  void drop() { due_ = 0.0; }
  /// Advances wall time to `wall` at this speed since the last call.
  void advance(double wall, double speed) {
    due_ += speed * (wall - last_);
    last_ = wall;
    if (wall - mark_ < kPart) return;
    last_parts_[parts_++ % kParts] = {played_, wall - mark_};
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
  /// Scene time played over wall time, over the last parts; NaN before the first has passed.
  double factor() const {
    if (parts_ == 0) return kNaN;
    Part sum;
    for (std::size_t i = 0; i < std::min(parts_, kParts); ++i) {
      sum.played += last_parts_[i].played;
      sum.wall += last_parts_[i].wall;
    }
    return sum.played / sum.wall;
  }

 private:
  struct Part {
    double played{0.0}, wall{0.0};
  };
  double last_{0.0}, mark_{0.0}, due_{0.0}, played_{0.0};
  std::array<Part, kParts> last_parts_;
  std::size_t parts_{0};  // that have passed
};

}  // namespace abstand::loop
