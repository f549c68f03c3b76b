// Filters that take the jitter out of joints, and what they cost in delay.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "humanmodel/joints.hpp"

namespace abstand::tracking {

/// Butterworth low-pass of second order, bilinear transform with the cutoff warped (textbook form). Starts at
/// rest in its first value. One coordinate triple; no allocation.
class Butterworth {
 public:
  /// `cutoff` and `rate` in Hz; the cutoff must lie between 0 and half of the rate.
  Butterworth(double cutoff, double rate);
  Vector3d step(const Vector3d& p);
  void reset() { started_ = false; }
  /// s that a slow movement comes late: sqrt(2) / (2 rate tan(pi cutoff / rate)).
  double delay() const { return delay_; }

 private:
  double b_, a1_, a2_, delay_;
  Vector3d x1_{Vector3d::Zero()}, x2_{x1_}, y1_{x1_}, y2_{x1_};
  bool started_{false};
};

/// One-Euro filter (Casiez, Roussel, Vogel, CHI 2012) with one speed for the three coordinates: low-pass of
/// first order whose cutoff is least + per_speed * |v|, v itself smoothed at 1 Hz.
class OneEuro {
 public:
  struct Options {
    double least{1.0};      ///< Hz at rest
    double per_speed{5.0};  ///< Hz per m/s: an arm at 1 m/s passes at 6 Hz
  };
  OneEuro(const Options& options, double rate);
  Vector3d step(const Vector3d& p);
  void reset() { started_ = false; }
  /// s that a movement of this speed (m/s) comes late: 1 / (2 pi cutoff).
  double delay(double speed) const;

 private:
  Options options_;
  double dt_;
  Vector3d p_{Vector3d::Zero()}, raw_{p_}, v_{p_};
  bool started_{false};
};

enum class Smoothing : std::uint8_t { kOneEuro, kButterworth, kButterworthBothWays };

/// "one-euro", "butterworth", "butterworth-both-ways".
const char* smoothingName(Smoothing smoothing);
std::optional<Smoothing> parseSmoothing(const std::string& name);

/// Hz below which a person's movements lie (6 Hz: Winter 2009, section 3.4); a lower rate is limited by a
/// third.
double smoothingCutoff(double rate);

/// Smooths every joint; starts anew behind a gap. The last one runs forwards and backwards: no delay, but
/// only for what is recorded already. `rate` in Hz, above 0.
void smooth(std::vector<humanmodel::SkeletonFrame>& frames, double rate, Smoothing smoothing);

}  // namespace abstand::tracking
