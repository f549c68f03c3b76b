// Quality figures of a recording of a person.
#pragma once

#include <string>
#include <vector>

#include "tracking/doctor/filters.hpp"
#include "tracking/doctor/gap_fill.hpp"
#include "tracking/recording/recording.hpp"

namespace abstand::tracking {

/// m/s, upper limit of joint speeds: the hand in a punch or a throw reaches about 10.
inline constexpr double kFastestJoint = 12.0;
/// s, gaps up to this length are filled reliably.
inline constexpr double kShortGap = 0.2;

struct BoneHealth {
  std::string part;
  double length{0.0};  ///< m, median over the frames with both ends
  double spread{0.0};  ///< m, range from the 5 % to the 95 % quantile
  double drift{0.0};   ///< m, median of the last tenth minus median of the first
};

struct JointHealth {
  std::string joint;
  std::size_t missing{0}, inferred{0};  ///< frames
  double longest_gap{0.0};              ///< s, from the last known frame before it to the first one after it
  double jitter{0.0};  ///< m, standard deviation of the noise of a coordinate; NaN: too few frames
  double speed{0.0};   ///< m/s, median
};

struct Jump {
  std::string joint;
  double t{0.0};      ///< s, time after the jump
  double speed{0.0};  ///< m/s
};

/// Result of a filter on this recording.
struct FilterHealth {
  std::string name;
  double delay{0.0};                             ///< s, at the median speed of the joints
  double delay_at_rest{0.0};                     ///< s
  double jitter_before{0.0}, jitter_after{0.0};  ///< m, median over the joints
  double moved{0.0};                             ///< m, 99 % quantile of the displacement by the filter
};

struct DoctorReport {
  double step{0.0}, longest_step{0.0};  ///< s, median and longest time between frames
  std::size_t uneven_steps{0};          ///< those more than 10 % off the median
  std::vector<BoneHealth> bones;
  std::vector<JointHealth> joints;
  std::vector<double> swaps;  ///< s, frames with left and right exchanged
  std::vector<Jump> jumps;
  std::vector<FilterHealth> filters;
  GapFill fill;  ///< result of fillGaps with kShortGap
};

/// Noise is estimated from third differences of consecutive frames, which remove position, velocity and
/// acceleration and have 20 times the variance of white noise (1 + 9 + 9 + 1). A swap is a frame in which
/// hips and shoulders are nearer to their previous positions if left and right are exchanged.
DoctorReport examine(const Recording& recording);

/// Standard deviation of the noise of a joint coordinate (m), by the median of its third differences, which
/// is robust to jumps and fast rotations; NaN without four consecutive frames.
double jitterOf(const std::vector<humanmodel::SkeletonFrame>& frames, humanmodel::Joint joint);

}  // namespace abstand::tracking
