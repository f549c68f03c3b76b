// How often several cameras are compared.
#pragma once

#include <algorithm>
#include <vector>

#include "core/math/transform.hpp"

namespace abstand::tracking {

/// Moments of several cameras that are compared: those with new images of at least two of them, at most one
/// in kEvery; but no camera waits longer than kOverdue for one with its image, as cameras whose images are in
/// other moments than those of the others would. One thread.
class ComparePace {
 public:
  explicit ComparePace(std::size_t cameras) : last_(cameras, -kInfinity) {}

  /// `t` (s) increases; `is_new`: for each camera.
  bool isDue(double t, const std::vector<bool>& is_new) const {
    if (std::count(is_new.begin(), is_new.end(), true) < 2) return false;
    if (t >= next_) return true;
    for (std::size_t c = 0; c < last_.size(); ++c)
      if (is_new[c] && t - last_[c] >= kOverdue) return true;
    return false;
  }
  /// The moment at `t` is compared.
  void note(double t, const std::vector<bool>& is_new) {
    next_ = t + kEvery;
    for (std::size_t c = 0; c < last_.size(); ++c)
      if (is_new[c]) last_[c] = t;
  }

  static constexpr double kEvery = 0.06;    ///< s: every second image
  static constexpr double kOverdue = 0.25;  ///< s

 private:
  std::vector<double> last_;  ///< s, of each camera's last image that was compared
  double next_{-kInfinity};   ///< s
};

}  // namespace abstand::tracking
