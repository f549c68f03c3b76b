// Stature of the recorded person, and the unit of the file derived from it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "humanmodel/joints.hpp"

namespace abstand::tracking {

/// Stature in the units of the frames, along the bones, so that it does not depend on the pose: head_top-neck
/// + neck-pelvis + pelvis-hips along the trunk + hip-knee + knee-ankle, mean of both legs, over sampled
/// frames, plus the height of the ankle, 0.039 of the stature (Drillis and Contini 1966, in Winter 2009, fig.
/// 4.1). The spine has the length of its straightest pose (rest pose, 90 % quantile over the frames). nullopt
/// if one of the joints is in no frame.
std::optional<double> measureStature(const humanmodel::SkeletonFrame& rest,
                                     const std::vector<humanmodel::SkeletonFrame>& frames);

/// Stature by the bones that are known.
struct BoneStature {
  double stature{0.0};  ///< units of the frames
  int bones{0};
};

/// Median over thighs, calves, upper arms, forearms and both sides of the trunk (shoulder to hip) of the
/// bone's length (median over sampled frames) over its usual share of stature (Drillis and Contini 1966,
/// ibid.). Rough, as people and the joints of files differ. nullopt if none of these bones is in any frame.
std::optional<BoneStature> statureByBones(const std::vector<humanmodel::SkeletonFrame>& frames);

/// Metres per unit of a file, with the reason.
struct UnitChoice {
  std::string name;  ///< "cm", ..., a number, or "free": scaled to an assumed stature
  std::string reason;
  double scale{1.0};    ///< m per unit
  std::string warning;  ///< empty: none
};

/// m; range of adult statures. A unit that gives a stature outside is rejected.
inline constexpr double kShortestAdult = 1.4, kTallestAdult = 2.1;
/// m; the same for a stature by bones.
inline constexpr double kShortestByBones = 1.2, kTallestByBones = 2.4;
/// m; if no usual unit fits, the person is scaled to this stature.
inline constexpr double kAssumedStature = 1.75;

/// Selects the unit of a file: `wanted` is "auto" or the user's choice: m, cm, mm, inches, cmu (the CMU data
/// base's 1 / 0.45 inch) or metres per unit as a number. Throws UsageError for anything else. With "auto" at
/// most one usual unit fits: their ratios are larger than that of the tallest to the shortest adult. Without
/// a stature, one by bones decides, in a wider range. A stature that the file states (m; 0: it does not)
/// replaces these ranges: the unit is that which comes within 40 % of it, without one the person is scaled to
/// it.
UnitChoice chooseUnit(const std::string& wanted, std::optional<double> stature_in_units,
                      std::optional<BoneStature> by_bones = std::nullopt, double stated_stature = 0.0);

/// m; statures that do not cast doubt on a unit that is stated.
struct StatureRange {
  double min{kShortestByBones}, max{kTallestByBones};
};

/// A sentence on a unit that the file or its format states, if the person measures `stature` of them and is
/// outside `plausible` with it: the stature, and the usual unit that would give kShortestByBones to
/// kTallestByBones. Empty: no doubt. Units differ by a factor of two and more, so the range is wider than
/// that of a guess.
std::string doubtOfUnit(const UnitChoice& stated, double stature, const StatureRange& plausible = {});

}  // namespace abstand::tracking
