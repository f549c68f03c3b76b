#include "tracking/recording/part_turns.hpp"

#include <algorithm>

namespace abstand::tracking {
namespace {

/// The point of a joint; -1 if it has none, or the mean of several.
int pointOf(const JointMatch& match, humanmodel::Joint joint, std::size_t points) {
  const int point = match.joint[static_cast<std::size_t>(joint)];
  return point < static_cast<int>(points) ? point : -1;
}

}  // namespace

void StatedTurns::choosePoints(const JointMatch& match, std::span<const int> parents) {
  for (std::size_t k = 0; k < kTurnedParts.size(); ++k) {
    const int end = pointOf(match, kTurnedParts[k].end, parents.size());
    source[k] = end >= 0 ? parents[static_cast<std::size_t>(end)] : -1;
    if (source[k] < 0) source[k] = pointOf(match, kTurnedParts[k].start, parents.size());
    if (source[k] < 0 && kTurnedParts[k].part == humanmodel::BodyPart::kHead)
      source[k] = pointOf(match, humanmodel::Joint::kNeck, parents.size());
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
