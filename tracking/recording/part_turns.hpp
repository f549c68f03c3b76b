// Rotations of body parts since the rest pose of a file.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <span>
#include <vector>

#include "humanmodel/body_part.hpp"
#include "humanmodel/joints.hpp"
#include "tracking/recording/joint_map.hpp"

namespace abstand::tracking {

/// A body part whose twist positions do not determine, or not always, and the joints at which it starts and
/// ends.
struct TurnedPart {
  humanmodel::BodyPart part;
  humanmodel::Joint start, end;
};
inline constexpr std::array<TurnedPart, 9> kTurnedParts{
    {{humanmodel::BodyPart::kBicepsLeft, humanmodel::Joint::kShoulderLeft, humanmodel::Joint::kElbowLeft},
     {humanmodel::BodyPart::kForearmLeft, humanmodel::Joint::kElbowLeft, humanmodel::Joint::kWristLeft},
     {humanmodel::BodyPart::kHandLeft, humanmodel::Joint::kWristLeft, humanmodel::Joint::kHandLeft},
     {humanmodel::BodyPart::kFootLeft, humanmodel::Joint::kAnkleLeft, humanmodel::Joint::kToeLeft},
     {humanmodel::BodyPart::kBicepsRight, humanmodel::Joint::kShoulderRight, humanmodel::Joint::kElbowRight},
     {humanmodel::BodyPart::kForearmRight, humanmodel::Joint::kElbowRight, humanmodel::Joint::kWristRight},
     {humanmodel::BodyPart::kHandRight, humanmodel::Joint::kWristRight, humanmodel::Joint::kHandRight},
     {humanmodel::BodyPart::kFootRight, humanmodel::Joint::kAnkleRight, humanmodel::Joint::kToeRight},
     {humanmodel::BodyPart::kHead, humanmodel::Joint::kHead, humanmodel::Joint::kHeadTop}}};
/// The parts on the left are followed by the same ones on the right, then by the head.
inline constexpr std::size_t kTurnedOfSide = 4;

/// Of each of kTurnedParts, in the axes of the file.
using PartTurns = std::array<Eigen::Quaternionf, kTurnedParts.size()>;

/// What a file states of the orientations of a person.
struct StatedTurns {
  /// For each of kTurnedParts the point of the file with which it turns; -1: none.
  std::array<int, kTurnedParts.size()> source{-1, -1, -1, -1, -1, -1, -1, -1, -1};
  humanmodel::SkeletonFrame rest;  ///< the pose in which all rotations are the identity, axes of the file
  std::vector<PartTurns> frames;   ///< one for each frame; empty: the file states none

  /// Sets `source`; `parents`: of the points. A part turns with the parent of the point at its end, which may
  /// be a twist bone, or with the point at its start if its end is none or a mean of points; the head then
  /// also with the neck.
  void choosePoints(const JointMatch& match, std::span<const int> parents);
  /// The next frame. `turns`: of all points (PointFrame::turn).
  void add(std::span<const Matrix3d> turns);
  /// Exchanges left and right.
  void swapSides();
};

}  // namespace abstand::tracking
