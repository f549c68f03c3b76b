// Reads the motion of a BVH file, frame by frame.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tracking/bvh/bvh_hierarchy.hpp"

namespace abstand::tracking {

/// A BVH text, opened. The numbers of a frame are counted, not its lines: a frame may be spread over several
/// lines, or several may share one. But where the first or the second line of the data holds exactly one
/// frame, every line must, so that a number that is missing cannot shift all frames after it.
///
/// What only spoils the end does not spoil the file: fewer or more frames than claimed, and a last frame that
/// is cut, are warnings, and all whole frames are given. Throws ParseError, with line and column, for
/// anything else. Not to be shared between threads. Memory grows with the text, never with what the text
/// claims.
class BvhReader {
 public:
  /// Takes the whole text; `file` names it in messages.
  BvhReader(std::string text, std::string file);
  BvhReader(const BvhReader&) = delete;
  BvhReader& operator=(const BvhReader&) = delete;

  const BvhHierarchy& hierarchy() const { return hierarchy_; }
  const BvhMotionHead& head() const { return head_; }

  /// The channel values of the next frame in file order (positions in units of the file, rotations in
  /// degrees), valid until the next call; nullopt after the last one. Throws ParseError; a file without any
  /// whole frame is an error.
  std::optional<std::span<const double>> next();

  std::size_t framesRead() const { return frames_; }
  /// Complete after next() gave nullopt.
  const std::vector<FileWarning>& warnings() const { return warnings_; }

 private:
  SourcePos here() const;
  void nextLine();
  bool lineHasMore();
  /// The next whole frame into values_; false at the end.
  bool readFrame();
  /// More frames were read than the header claims.
  bool beyondClaim() const;
  std::size_t wordsIn(std::size_t from, std::size_t to) const;
  void chooseLayout();
  bool readNumber(double& value);
  bool finish(std::size_t values_of_partial_frame);

  std::string text_, file_;
  std::vector<FileWarning> warnings_;
  BvhHierarchy hierarchy_;
  BvhMotionHead head_;
  std::size_t at_{0}, line_start_{0};
  int line_{1}, data_line_{1};  ///< now, and of the last number
  bool frame_a_line_{false}, done_{false}, cut_{false};
  std::size_t frames_{0};
  std::vector<double> values_;
};

}  // namespace abstand::tracking
