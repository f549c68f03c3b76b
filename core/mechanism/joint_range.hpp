// The joint values that a mechanism can take.
#pragma once

#include <span>
#include <vector>

#include "core/math/random.hpp"
#include "core/mechanism/mechanism.hpp"

namespace abstand::mechanism {

/// Values of q (rad, m), both finite.
struct JointRange {
  double lower{0.0}, upper{0.0};
  bool unlimited{false};  ///< the file has no limits: one turn, or 1 m either way
};

/// One a degree of freedom, from the limits of the joint that leads it; those of joints that mimic it are not
/// asked, because they are moved whatever they say.
std::vector<JointRange> jointRanges(const Mechanism& mechanism);

/// Uniform within the ranges; `q` has a place for each.
void randomPosture(std::span<const JointRange> ranges, Random& random, std::span<double> q);

}  // namespace abstand::mechanism
