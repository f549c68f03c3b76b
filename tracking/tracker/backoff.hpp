// Less frequent attempts while they are in vain.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/math/transform.hpp"

namespace abstand::tracking {

/// Exponential backoff of attempts that take as long as several images. Until `free` consecutive ones were in
/// vain, the next one is due at any time, then after a wait that grows with each further one. One thread.
class Backoff {
 public:
  struct Waits {
    int free;        ///< attempts
    double first;    ///< s, after the free attempts, and after a success if none is free
    double growth;   ///< factor, at least 1
    double longest;  ///< s
  };
  explicit Backoff(const Waits& waits) : waits_{waits} {}

  /// `t` (s) does not decrease.
  bool isDue(double t) const { return vain_ < waits_.free || t - last_t_ >= wait(); }
  /// An attempt at `t` (s).
  void note(double t, bool succeeded) {
    last_t_ = t;
    vain_ = succeeded ? 0 : vain_ + 1;
  }
  /// Forgets all attempts.
  void reset() { *this = Backoff(waits_); }

 private:
  double wait() const {
    return std::min(waits_.longest, waits_.first * std::pow(waits_.growth, vain_ - waits_.free));
  }

  Waits waits_;
  double last_t_{-kInfinity};  ///< s, of the last attempt
  int vain_{0};                ///< consecutive attempts in vain
};

}  // namespace abstand::tracking
