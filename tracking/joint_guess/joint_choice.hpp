// Which joint of a file is which: the user's map, an included one, or a guess.
#pragma once

#include "tracking/joint_guess/shape_guess.hpp"
#include "tracking/recording/recording.hpp"

namespace abstand::tracking {

struct JointChoice {
  JointMatch match;                ///< without a map's name if nothing is mapped
  bool is_guess{false};            ///< by names word by word, or by shape
  std::string reason;              ///< for the map or the guess, the rest of a sentence
  std::string filled;              ///< joints that the map lacks and that are guessed; empty: none
  std::vector<std::string> notes;  ///< limbs that were left out of a guess
  std::string misses;              ///< entries of the user's map that the file lacks; empty: none
};

/// The user's map always wins. Otherwise the included map that finds most joints, unless it finds fewer than
/// kEnoughLimbJoints of the twelve limb joints and a guess finds more: first by the names, checked for
/// proportions, then by hierarchy and geometry. Where limb joints or the pelvis are then missing, they are
/// added from the guesses, in this order, if these agree with what is there. `may_guess`: false for markers,
/// whose labels name places on the skin. Throws ParseError for the maps.
JointChoice chooseJoints(const SkeletonSample& skeleton, const RecordingOptions& options, bool may_guess);

inline constexpr int kEnoughLimbJoints = 9;  // a map that finds them fits: it is filled, not replaced

/// Canonical joints of a frame by a match; joints that are the mean of several points are missing if one of
/// them is, and inferred if one of them is.
humanmodel::SkeletonFrame pickJoints(const PointFrame& from, const JointMatch& match);

}  // namespace abstand::tracking
