// Joint ranges of a mechanism.
#pragma once

#include <span>
#include <vector>

#include "core/math/random.hpp"
#include "core/mechanism/mechanism.hpp"

namespace abstand::mechanism {

/// Range of q (rad, m), both ends finite.
struct JointRange {
  double lower{0.0}, upper{0.0};
  bool unlimited{false};  ///< without limits in the file: one turn, or 1 m either way
};

/// One range for each dof, from the limits of the joint that leads it; limits of mimic joints are ignored, as
/// they follow it anyway.
std::vector<JointRange> jointRanges(const Mechanism& mechanism);

/// Uniformly distributed within the ranges; `q` has one entry for each.
void randomPosture(std::span<const JointRange> ranges, Random& random, std::span<double> q);

}  // namespace abstand::mechanism
