// A joint map from the hierarchy and the geometry of a skeleton, for names that say nothing.
#pragma once

#include <span>
#include <string>

#include "tracking/recording/joint_map.hpp"
#include "tracking/recording/point_reader.hpp"

namespace abstand::tracking {

/// A skeleton with names, parents (index, smaller than the own; -1: none), rest positions and some frames.
struct SkeletonSample {
  std::span<const std::string> names;
  std::span<const int> parents;
  std::span<const Vector3d> rest;
  std::span<const PointFrame> frames;
  bool is_tree_guessed{false};  ///< the head may leave the trunk beside the joint that the arms leave
};

struct ShapeGuess {
  JointMatch match;    ///< nothing mapped: none
  std::string reason;  ///< for the guess, or for none; the rest of a sentence
};

/// Two pairs of symmetric branches are legs and arms if their proportions are those of a person (shares of
/// Drillis and Contini 1966, in Winter 2009, fig. 4.1), the legs point away from the arms' joint, and a third
/// branch goes on there to the head. If no branches are symmetric in full, hip to ankle and shoulder to wrist
/// suffice: hands and feet may differ. If no pair has the proportions of arms, and no other one is long, a
/// pair of legs with toes below a trunk suffices; arms are missing then. Left and right follow from the names
/// where all of them say a side, and otherwise from where toes or bent knees point. None if two readings are
/// equally good, or if left and right do not show.
ShapeGuess guessByShape(const SkeletonSample& skeleton);

}  // namespace abstand::tracking
