// Which joints of a branch are those of a leg or of an arm, by their proportions.
#pragma once

#include <optional>

#include "tracking/joint_guess/skeleton_tree.hpp"

namespace abstand::tracking {

enum class LimbKind : std::uint8_t { kLeg, kArm };

/// Joints of a pair of limbs, as indices into the nodes of both branches, and their lengths, mean of both
/// sides.
struct LimbChoice {
  std::size_t first{0}, middle{0}, last{0};  ///< hip, knee, ankle, or shoulder, elbow, wrist
  double upper{0.0}, lower{0.0};             ///< units of the file
  double cost{0.0};                          ///< sum of squares, in standard deviations
};

/// The choice with the usual proportions: thigh and calf are alike, upper arm 1.27 of the forearm (Drillis
/// and Contini 1966, in Winter 2009, fig. 4.1), with the usual rest before and behind. nullopt if a branch
/// has too few joints.
std::optional<LimbChoice> chooseLimb(const BranchPair& pair, LimbKind kind);

/// ((ln(value / usual)) / deviation)^2, at most 25.
double oddness(double value, double usual, double deviation);

}  // namespace abstand::tracking
