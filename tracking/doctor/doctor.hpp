// What is wrong with a recording of a person, in figures.
#pragma once

#include <string>
#include <vector>

#include "tracking/doctor/filters.hpp"
#include "tracking/doctor/gap_fill.hpp"
#include "tracking/recording/recording.hpp"

namespace abstand::tracking {

/// No joint of a person is faster (m/s): the hand of a punch or a throw reaches about 10.
inline constexpr double kFastestJoint = 12.0;
/// Gaps up to this (s) are filled without much doubt.
inline constexpr double kShortGap = 0.2;

struct BoneHealth {
  std::string part;
  double length{0.0};  ///< m, median over the frames that show both ends
  double spread{0.0};  ///< m, between the 5 % and the 95 % quantile
  double drift{0.0};   ///< m, median of the last tenth minus that of the first
};

struct JointHealth {
  std::string joint;
  std::size_t missing{0}, inferred{0};  ///< frames
  double longest_gap{0.0};              ///< s, from the last place before it to the first behind it
  double jitter{0.0};  ///< m, standard deviation of the noise in a coordinate; NaN: too few frames
  double speed{0.0};   ///< m/s, median
};

struct Jump {
  std::string joint;
  double t{0.0};      ///< s, behind the jump
  double speed{0.0};  ///< m/s
};

/// A filter, tried on this recording.
struct FilterHealth {
  std::string name;
  double delay{0.0};                             ///< s, at the median speed of the joints
  double delay_at_rest{0.0};                     ///< s
  double jitter_before{0.0}, jitter_after{0.0};  ///< m, median over the joints
  double moved{0.0};                             ///< m, 99 % of the places are moved by less
};

struct DoctorReport {
  double step{0.0}, longest_step{0.0};  ///< s, median and longest time between frames
  std::size_t uneven_steps{0};          ///< more than 10 % off the median
  std::vector<BoneHealth> bones;
  std::vector<JointHealth> joints;
  std::vector<double> swaps;  ///< s, frames in which left and right changed places
  std::vector<Jump> jumps;
  std::vector<FilterHealth> filters;
  GapFill fill;  ///< what fillGaps would do with kShortGap
};

/// Noise comes from third differences of neighbouring frames: they take out position, velocity and
/// acceleration, and their variance is 20 times that of white noise (1 + 9 + 9 + 1). A swap is a frame in
/// which hips and shoulders come nearer to their places of the frame before when left and right are
/// exchanged.
DoctorReport examine(const Recording& recording);

/// Standard deviation of the noise in a coordinate of a joint (m), by the median of its third differences, so
/// that jumps and quick turns count little; NaN where no four frames in a row have it.
double jitterOf(const std::vector<humanmodel::SkeletonFrame>& frames, humanmodel::Joint joint);

}  // namespace abstand::tracking
