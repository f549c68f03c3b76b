// Hierarchy of a BVH file: tree of joints, their channels, and the head of the motion.
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

/// Degree of freedom of a channel. Rotations are in degrees about the joint's own axes.
enum class BvhChannel : std::uint8_t {
  kXPosition,
  kYPosition,
  kZPosition,
  kXRotation,
  kYRotation,
  kZRotation
};

/// A joint or an end site. End sites have no channels and are named "PARENT/end".
struct BvhJoint {
  std::string name;
  int parent{-1};  ///< index into the list; -1 for the root; always smaller than the own index
  Vector3d offset{Vector3d::Zero()};  ///< from the parent, in the parent's axes, units of the file
  std::vector<BvhChannel> channels;   ///< in file order: R = R(first) R(second) R(third)
  std::size_t first_channel{0};       ///< index of its first channel in a frame
};

struct BvhHierarchy {
  std::vector<BvhJoint> joints;  ///< the first root and all its descendants, parents first
  std::size_t channel_count{0};  ///< numbers in a frame, including those of further roots
};

/// Limit of lengths and channel values; keeps sums finite.
inline constexpr double kLargestBvhValue = 1e9;
/// Limits of nesting and of the number of joints.
inline constexpr std::size_t kDeepestBvhJoint = 512;
inline constexpr std::size_t kMaxBvhJoints = 10000;
/// s; frame time used if the file states no usable one.
inline constexpr double kAssumedFrameTime = 1.0 / 30.0;

/// Parses from `HIERARCHY` up to `MOTION`, exclusive. Keywords in any case; a name is the rest of its line.
/// Throws ParseError with line and column.
BvhHierarchy parseBvhHierarchy(TextCursor& in, std::vector<FileWarning>& warnings);

/// Text between `MOTION` and the first number.
struct BvhMotionHead {
  long long frames{0};  ///< as stated; never used for allocation
  int frames_line{0};
  double frame_time{kAssumedFrameTime};  ///< s, > 0
};
BvhMotionHead parseBvhMotionHead(TextCursor& in, std::vector<FileWarning>& warnings);

}  // namespace abstand::tracking
