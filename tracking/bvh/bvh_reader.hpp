// Reads the motion of a BVH file, frame by frame.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tracking/bvh/bvh_hierarchy.hpp"

namespace abstand::tracking {

/// A BVH text. Frames are delimited by the number of values, not by lines: a frame may span several lines, or
/// several may share one. But if the first or the second line of the data has exactly one frame, every line
/// must, so that a missing number cannot shift all later frames.
///
/// Errors at the end are tolerated: fewer or more frames than stated, and an incomplete last frame, are
/// warnings, and all complete frames are returned. Throws ParseError, with line and column, for any other
/// error. Not shared between threads. Memory grows with the text, never with what it states.
class BvhReader {
 public:
  /// Takes the whole text; `file` is its name in messages.
  BvhReader(std::string text, std::string file);
  BvhReader(const BvhReader&) = delete;
  BvhReader& operator=(const BvhReader&) = delete;

  const BvhHierarchy& hierarchy() const { return hierarchy_; }
  const BvhMotionHead& head() const { return head_; }

  /// The channel values of the next frame in file order (positions in units of the file, rotations in
  /// degrees), valid until the next call; nullopt after the last one. Throws ParseError; also for a file
  /// without a complete frame.
  std::optional<std::span<const double>> next();

  std::size_t framesRead() const { return frames_; }
  /// Complete after next() has returned nullopt.
  const std::vector<FileWarning>& warnings() const { return warnings_; }

 private:
  SourcePos here() const;
  void nextLine();
  bool lineHasMore();
  /// Reads the next complete frame into values_; false at the end.
  bool readFrame();
  /// True if more frames were read than the header states.
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
  int line_{1}, data_line_{1};  ///< current line, and that of the last number
  bool frame_a_line_{false}, done_{false}, cut_{false};
  std::size_t frames_{0};
  std::vector<double> values_;
};

}  // namespace abstand::tracking
