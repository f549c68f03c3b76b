// Smoothing filters for joints, and their delay.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "humanmodel/joints.hpp"

namespace abstand::tracking {

/// Second-order Butterworth low-pass, bilinear transform with frequency warping (textbook form). Starts at
/// rest at its first value. One coordinate triple; no allocation.
class Butterworth {
 public:
  /// `cutoff` and `rate` in Hz; the cutoff must be between 0 and half of the rate.
  Butterworth(double cutoff, double rate);
  Vector3d step(const Vector3d& p);
  void reset() { started_ = false; }
  /// Delay (s) of slow movements: sqrt(2) / (2 rate tan(pi cutoff / rate)).
  double delay() const { return delay_; }

 private:
  double b_, a1_, a2_, delay_;
  Vector3d x1_{Vector3d::Zero()}, x2_{x1_}, y1_{x1_}, y2_{x1_};
  bool started_{false};
};

/// One-Euro filter (Casiez, Roussel, Vogel, CHI 2012) with one speed for the three coordinates: first-order
/// low-pass with the cutoff least + per_speed * |v|, where v is smoothed at 1 Hz.
class OneEuro {
 public:
  struct Options {
    double min_cutoff{1.0};  ///< Hz, cutoff at rest
    double per_speed{5.0};   ///< Hz per m/s: an arm at 1 m/s has a cutoff of 6 Hz
  };
  OneEuro(const Options& options, double rate);
  Vector3d step(const Vector3d& p);
  void reset() { started_ = false; }
  /// Delay (s) of a movement of this speed (m/s): 1 / (2 pi cutoff).
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

/// Cutoff (Hz) above the frequencies of human movement (6 Hz: Winter 2009, section 3.4); at low rates at most
/// a third of the rate.
double smoothingCutoff(double rate);

/// Smooths every joint; restarts after a gap. The last kind runs forwards and backwards: no delay, but only
/// for complete recordings. `rate` in Hz, above 0.
void smooth(std::vector<humanmodel::SkeletonFrame>& frames, double rate, Smoothing smoothing);

}  // namespace abstand::tracking
