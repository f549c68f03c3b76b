// Certified minimum of a distance over a time interval, from samples and a bound on its rate of change.
#pragma once

#include <algorithm>
#include <array>

#include "core/config/number_rule.hpp"

namespace abstand::safety {

struct SweptOptions {
  static constexpr const char* kName = "swept";
  double tolerance{1e-3};    ///< m; stops when further samples cannot raise `lower` by more
  double enough{kInfinity};  ///< m; stops when the lower bound has reached this ...
  double hit{-kInfinity};    ///< m; ... or a sample has fallen below this
  int max_samples{64};       ///< 2 to kMaxSweptSamples; the result stays certified when they are used up

  template <class Self, class Visit>
  static void eachNumber(Self& o, Visit visit) {
    visit("tolerance", o.tolerance, config::NumberRule{0.0, 10.0, "m"});
    visit("enough", o.enough, config::NumberRule{-kInfinity, kInfinity, "m"});
    visit("hit", o.hit, config::NumberRule{-kInfinity, kInfinity, "m"});
  }
  void validate() const;  ///< throws UsageError
};

inline constexpr int kMaxSweptSamples = 512;

/// Bounds on a distance at one time: lower <= distance <= upper. m, signed.
struct DistanceSample {
  double lower{kNaN}, upper{kNaN};
};

/// lower <= minimum of the distance over [0, T] <= upper. Their gap is limited by the tolerance and by the
/// bounds of the samples.
struct SweptResult {
  double lower{-kInfinity}, upper{kInfinity};  ///< m
  double t{0.0};                               ///< s, of the sample with the smallest `upper`
  int samples{0};
  bool done{false};  ///< ended by tolerance, `enough` or `hit`; false: the samples were used up
};

/// Lower bound of the distance over [a, b], if it is at least `lower_a` at a and `lower_b` at b and changes
/// by at most `rate` m/s: (lower_a + lower_b - rate (b - a)) / 2, or the bound of an end if that is smaller.
/// Also valid for a motion of which only start, end and speed bounds are known.
inline double minBetween(double lower_a, double lower_b, double rate, double duration) noexcept {
  // Avoids 0 * infinity: in no time nothing moves.
  const double max_change = duration > 0.0 ? rate * duration * (1.0 + 1e-12) : 0.0;
  // Each end also bounds the other.
  const double a = std::max(lower_a, lower_b - max_change), b = std::max(lower_b, lower_a - max_change);
  return 0.5 * (a + b - max_change);
}

/// Known samples at both ends of the interval, which are then not computed.
struct SweptEnds {
  DistanceSample first, last;
};

/// Branch and bound over intervals [Piyavskii 1972, Shubert 1972; conservative advancement, Mirtich 1996, in
/// both directions of time]. Instead of swept volumes [thesis's [33]] it evaluates the distance at selected
/// times: it starts with both ends and splits the interval with the lowest lower bound at its most critical
/// time.
/// @param duration  T >= 0, s
/// @param sample    DistanceSample(double t)
/// @param rate      double(double t0, double t1): m/s, bound on the change of the distance within [t0, t1]
/// @param ends      null: both ends are sampled
/// No allocation. Cost of each step: one sample() and a scan of all intervals.
template <class Sample, class Rate>
SweptResult sweptDistance(double duration, Sample&& sample, Rate&& rate, const SweptOptions& options,
                          const SweptEnds* ends = nullptr) {
  struct Interval {
    double a, b, lower_a, lower_b, rate, lower;
  };
  std::array<Interval, static_cast<std::size_t>(kMaxSweptSamples)> intervals;
  std::size_t count = 0;
  SweptResult result;
  double smallest = kInfinity;  // minimum of the samples' lower bounds
  const auto sampleAt = [&](double t, const DistanceSample* known = nullptr) {
    const DistanceSample s = known ? *known : sample(t);
    result.samples += known == nullptr;
    if (s.upper < result.upper) result.upper = s.upper, result.t = t;
    if (!(s.lower >= smallest)) smallest = s.lower;
    return s.lower;
  };
  const auto interval = [&](double a, double b, double lower_a, double lower_b) {
    const double r = rate(a, b);
    return Interval{a, b, lower_a, lower_b, r, minBetween(lower_a, lower_b, r, b - a)};
  };

  const double first = sampleAt(0.0, ends ? &ends->first : nullptr);
  if (!(duration > 0.0)) {
    result.lower = first;
    result.done = true;
    return result;
  }
  intervals[count++] = interval(0.0, duration, first, sampleAt(duration, ends ? &ends->last : nullptr));

  const int limit = std::clamp(options.max_samples, 2, kMaxSweptSamples);
  for (;;) {
    std::size_t worst = 0;
    for (std::size_t i = 1; i < count; ++i)
      if (!(intervals[i].lower >= intervals[worst].lower)) worst = i;
    Interval& w = intervals[worst];
    result.lower = w.lower;
    result.done = smallest - result.lower <= options.tolerance || result.lower >= options.enough ||
                  result.upper < options.hit;
    if (result.done || result.samples >= limit) return result;
    // Where the bounds from both ends intersect, if not at an end.
    const double length = w.b - w.a, lean = w.rate > 0.0 ? (w.lower_a - w.lower_b) / (2.0 * w.rate) : 0.0;
    double t = w.a + std::clamp(0.5 * length + lean, 0.1 * length, 0.9 * length);
    if (!(t > w.a && t < w.b)) t = w.a + 0.5 * length;
    if (!(t > w.a && t < w.b)) return result;  // no double in between
    const double lower = sampleAt(t);
    intervals[count++] = interval(t, w.b, lower, w.lower_b);
    w = interval(w.a, t, w.lower_a, lower);
  }
}

}  // namespace abstand::safety
