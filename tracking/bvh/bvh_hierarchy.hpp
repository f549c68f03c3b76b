// The first half of a BVH file: the tree of joints, their channels, and the head of the motion.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/error.hpp"
#include "core/math/transform.hpp"
#include "tracking/recording/file_warning.hpp"
#include "tracking/recording/text_cursor.hpp"

namespace abstand::tracking {

/// What one number of a frame moves. Rotations are in degrees about the joint's own axes.
enum class BvhChannel : std::uint8_t {
  kXPosition,
  kYPosition,
  kZPosition,
  kXRotation,
  kYRotation,
  kZRotation
};

/// A joint or an end site. End sites have no channels and carry their parent's name with "/end".
struct BvhJoint {
  std::string name;
  int parent{-1};  ///< index into the list; -1 for the root; always smaller than the own index
  Vector3d offset{Vector3d::Zero()};  ///< from the parent, in the parent's axes, units of the file
  std::vector<BvhChannel> channels;   ///< in file order: R = R(first) R(second) R(third)
  std::size_t first_channel{0};       ///< place of the first of them in a frame
};

struct BvhHierarchy {
  std::vector<BvhJoint> joints;  ///< the first root and all below it, parents first
  std::size_t channel_count{0};  ///< numbers in a frame, those of further roots included
};

/// Lengths and channel values beyond this are refused: no body is measured so, and sums of them stay finite.
inline constexpr double kLargestBvhValue = 1e9;
/// Nesting and number of joints beyond these are refused.
inline constexpr std::size_t kDeepestBvhJoint = 512;
inline constexpr std::size_t kMaxBvhJoints = 10000;
/// The time between frames, in seconds, where the file states none that is usable.
inline constexpr double kAssumedFrameTime = 1.0 / 30.0;

/// Reads `HIERARCHY ...` up to and without `MOTION`. Keywords in any case; a name is the rest of its line.
/// Throws ParseError with line and column.
BvhHierarchy parseBvhHierarchy(TextCursor& in, std::vector<FileWarning>& warnings);

/// What stands between `MOTION` and the first number.
struct BvhMotionHead {
  long long frames{0};  ///< as claimed; nothing is ever allocated by it
  int frames_line{0};
  double frame_time{kAssumedFrameTime};  ///< s, > 0
};
BvhMotionHead parseBvhMotionHead(TextCursor& in, std::vector<FileWarning>& warnings);

}  // namespace abstand::tracking
