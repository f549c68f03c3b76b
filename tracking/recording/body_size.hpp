// How tall the recorded person is, and what that says about the units of the file.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "humanmodel/joints.hpp"

namespace abstand::tracking {

/// Stature in the units of the frames, along the bones, so that bent and lying poses count as upright ones
/// do: head_top-neck + neck-pelvis + pelvis-hips along the trunk + hip-knee + knee-ankle, the legs' mean of
/// both sides, each over sampled frames, and the height of the ankle, 0.039 of the stature (Drillis and
/// Contini 1966, in Winter 2009, fig. 4.1). The spine counts as long as it is at its straightest (rest pose,
/// 90 % of the frames). Nullopt where one of the joints is in no frame.
std::optional<double> measureStature(const humanmodel::SkeletonFrame& rest,
                                     const std::vector<humanmodel::SkeletonFrame>& frames);

/// Metres per unit of a file, and why.
struct UnitChoice {
  std::string name;  ///< "cm", ..., a number, or "free": scaled to a stature
  std::string reason;
  double scale{1.0};    ///< m per unit
  std::string warning;  ///< empty: nothing to warn of
};

/// The stature of an adult lies within these (m); a unit that puts it outside is not believed.
inline constexpr double kShortestAdult = 1.4, kTallestAdult = 2.1;
/// Where no usual unit fits, the person is scaled to this stature (m).
inline constexpr double kAssumedStature = 1.75;

/// Picks the unit of a file: `wanted` is "auto" or what the user says: m, cm, mm, inches, cmu (the CMU data
/// base's 1 / 0.45 inch) or metres per unit as a number. Throws UsageError for anything else. With "auto" no
/// two of the usual units can both fit: their ratios are larger than that of the tallest to the shortest
/// adult.
UnitChoice chooseUnit(const std::string& wanted, std::optional<double> stature_in_units);

}  // namespace abstand::tracking
