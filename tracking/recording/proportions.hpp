// Proportions of a recorded body beside those of ANSUR II.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "humanmodel/body_part.hpp"
#include "humanmodel/joints.hpp"

namespace abstand::tracking {

/// One bone. Lengths in m.
struct BoneProportion {
  humanmodel::BodyPart part{};
  double length{0.0};  ///< median over sampled frames
  double usual{0.0};   ///< mean of ANSUR II for a person as tall as the bones say in the median
  double off() const { return length / usual - 1.0; }
  /// True if `off` is beyond kOddProportion.
  bool isOdd() const;
};

/// Share by which a bone may be off. At one stature people differ by some 5 %, and conventions of where a
/// joint lies by 10 to 15 %.
inline constexpr double kOddProportion = 0.25;

/// Trunk (hips to neck), head, upper arms, forearms, thighs and calves, from joints that were measured
/// (tracked); those that are inferred do not count. Independent of the unit. Empty if fewer than three bones
/// are known.
std::vector<BoneProportion> proportionsOf(std::span<const humanmodel::SkeletonFrame> frames);

/// A sentence on the bones that are odd; empty: none.
std::string oddProportions(std::span<const BoneProportion> bones);

}  // namespace abstand::tracking
