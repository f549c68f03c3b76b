// Proportions of a recorded body beside those of ANSUR II.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "humanmodel/body_part.hpp"
#include "humanmodel/joints.hpp"

namespace abstand::tracking {

/// Share by which a bone may be off. At one stature people differ by some 5 %, and conventions of where a
/// joint lies by 10 to 15 %.
inline constexpr double kOddProportion = 0.25;

/// One bone. Lengths in m.
struct BoneProportion {
  std::string part;    ///< as in scene files, "shoulder_breadth" or "hip_breadth"
  double length{0.0};  ///< median over sampled frames
  double usual{0.0};   ///< mean of ANSUR II for a person as tall as the bones say in the median
  double shortest{-kOddProportion}, longest{kOddProportion};  ///< limits of `off`
  double off() const { return length / usual - 1.0; }
  bool isOdd() const { return off() < shortest || off() > longest; }
};

/// Trunk (hips to neck), head, upper arms, forearms, thighs and calves, from joints that were measured
/// (tracked); those that are inferred do not count. Then, with wide limits because joints lie within the
/// body, the distances of the shoulders beside the biacromial breadth (0.6 to 1.5 of it), of the hips beside
/// the hip breadth (0.3 to 0.95), and from ankle to toe beside the length of the foot (0.2 to 1.1). Of
/// captures they are 0.74 to 1.24, 0.44 to 0.77 and 0.33 to 0.80. Independent of the unit. Empty if fewer
/// than three bones are known.
std::vector<BoneProportion> proportionsOf(std::span<const humanmodel::SkeletonFrame> frames);

/// A sentence on the bones that are odd; empty: none.
std::string oddProportions(std::span<const BoneProportion> bones);

}  // namespace abstand::tracking
