#include "tracking/recording/part_turns.hpp"

#include <algorithm>

namespace abstand::tracking {
namespace {

using J = humanmodel::Joint;

/// The joint at which a part starts; the head turns with its own joint, or with the neck.
std::array<J, 2> startsOf(J end) {
  switch (end) {
    case J::kElbowLeft:
      return {J::kShoulderLeft, J::kShoulderLeft};
    case J::kWristLeft:
      return {J::kElbowLeft, J::kElbowLeft};
    case J::kHandLeft:
      return {J::kWristLeft, J::kWristLeft};
    case J::kToeLeft:
      return {J::kAnkleLeft, J::kAnkleLeft};
    case J::kElbowRight:
      return {J::kShoulderRight, J::kShoulderRight};
    case J::kWristRight:
      return {J::kElbowRight, J::kElbowRight};
    case J::kHandRight:
      return {J::kWristRight, J::kWristRight};
    case J::kToeRight:
      return {J::kAnkleRight, J::kAnkleRight};
    default:
      return {J::kHead, J::kNeck};
  }
}

/// The point of a joint; -1 if it has none, or the mean of several.
int pointOf(const JointMatch& match, J joint, std::size_t points) {
  const int point = match.joint[static_cast<std::size_t>(joint)];
  return point < static_cast<int>(points) ? point : -1;
}

}  // namespace

void StatedTurns::choosePoints(const JointMatch& match, std::span<const int> parents) {
  for (std::size_t k = 0; k < kTurnedParts.size(); ++k) {
    const int end = pointOf(match, kTurnedParts[k].end, parents.size());
    source[k] = end >= 0 ? parents[static_cast<std::size_t>(end)] : -1;
    for (const J start : startsOf(kTurnedParts[k].end))
      if (source[k] < 0) source[k] = pointOf(match, start, parents.size());
  }
}

void StatedTurns::add(std::span<const Matrix3d> turns) {
  PartTurns& frame = frames.emplace_back();
  for (std::size_t k = 0; k < kTurnedParts.size(); ++k)
    frame[k] = source[k] < 0 ? Eigen::Quaternionf::Identity()
                             : Quaterniond(turns[static_cast<std::size_t>(source[k])]).cast<float>();
}

void StatedTurns::swapSides() {
  const auto swap = [](auto& of) {
    std::swap_ranges(of.begin(), of.begin() + kTurnedOfSide, of.begin() + kTurnedOfSide);
  };
  swap(source);
  for (PartTurns& frame : frames) swap(frame);
}

}  // namespace abstand::tracking
