// A stretch of frames that is judged as a whole.
#pragma once

#include <array>
#include <cstdint>

#include "core/margin/outcome_stream.hpp"

namespace abstand::margin {

/// Up to kFrames consecutive frames of a recording, each with the least values of everything that is watched
/// together. What sets of margins have in common is computed once for the block, so that a set costs a few
/// operations for each of its stops, not for each frame.
class FrameBlock {
 public:
  static constexpr std::size_t kFrames = 64;

  bool empty() const { return size_ == 0; }
  bool full() const { return size_ == kFrames; }
  std::size_t size() const { return size_; }
  void clear() { size_ = 0; }
  /// `inside` of the frame has no meaning here. Not when full().
  void add(const MarginFrame& frame);
  /// After the last add() and before judge(). `limit`: m, MarginOptions::limit.
  void close(double limit);
  /// Tells the stream what OutcomeStream::add() would tell it, frame by frame: bit i of `inside` is
  /// MarginFrame::inside of frame i.
  void judge(std::uint64_t inside, OutcomeStream& stream) const;

 private:
  /// Of the frames `begin` to `end` - 1: m, clearance and between.
  double least(std::size_t begin, std::size_t end) const;

  static constexpr std::size_t kLevels = 7;  ///< log2(kFrames) + 1
  std::size_t size_{0};
  std::array<double, kFrames> t_, braking_, between_;
  /// Sparse table of range minima: entry i of level l is the least of the 2^l frames from frame i on.
  std::array<std::array<double, kFrames>, kLevels> least_;
  std::uint64_t at_limit_{0};       ///< frames at or before whose next frame the limit is reached
  std::uint64_t between_limit_{0};  ///< the same, of what is between the frames alone
};

}  // namespace abstand::margin
